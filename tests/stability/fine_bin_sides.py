"""The sides of the 100 um bin below its floor."""
CLOSED = {"boundary_below_kind": "wall_free_slip", "boundary_bottom_kind": "wall_free_slip"}
