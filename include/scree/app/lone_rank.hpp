/// What Open MPI need not do for a run on one rank.
#pragma once

namespace scree {

/// Before MPI_Init: a process that no launcher started, or started alone, has nobody to wait for and no network to use.
/// It is not to yield its core whenever it asks for messages, which MUMPS does so often that on a busy machine a run
/// takes a hundred times longer; and it needs no daemon beside it. The directory that it shares with others of its kind
/// stays when these end. What the environment says of daemon and network stays. Other kinds of MPI do not read these
/// variables.
void set_up_lone_rank();

}  // namespace scree
