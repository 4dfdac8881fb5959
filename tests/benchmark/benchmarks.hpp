/// What kernels_benchmark measures, a function a file. Names are group/what/...; times are CPU times of one core.
#pragma once

#include <string>

namespace scree::benchmarks {

/// The limits of the machine: bandwidth to memory, and multiply-adds in vector registers.
void add_machine();
/// The closures, an evaluation at a time, with plain numbers and with the dual numbers that kernels use.
void add_closures();
/// Residual and Jacobian of whole problems, for scenes in the folder `cases`.
void add_assembly(const std::string& cases);
/// Set-up and solve of the default preconditioners on the Jacobian of a flow that has developed.
void add_preconditioners(const std::string& cases);

}  // namespace scree::benchmarks
