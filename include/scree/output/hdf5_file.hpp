/// A thin layer over the HDF5 C API with MPI-IO: handles that close themselves, files that all ranks write together.
#pragma once

#include <hdf5.h>
#include <petscsys.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scree/output/seal.hpp"

namespace scree {

/// Owns one HDF5 identifier; negative: none.
class Hdf5Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), closer_(other.closer_) { other.id_ = -1; }
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  ~Hdf5Handle() { close(); }
  bool valid() const { return id_ >= 0; }
  hid_t id() const { return id_; }
  bool close();  ///< false if HDF5 reports an error (data may be lost then)

 private:
  hid_t id_ = -1;
  Closer closer_ = nullptr;
};

/// For H5Fopen() by all ranks of `comm` together, through MPI-IO: by ROMIO where Open MPI has both ROMIO and its own
/// OMPIO, unless OMPI_MCA_io_ompio_priority is set.
Hdf5Handle shared_access(MPI_Comm comm);

/// Keeps HDF5 from printing its error stack while it lives.
class QuietHdf5 {
 public:
  QuietHdf5();
  ~QuietHdf5();
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// The part of an array that this rank holds, slowest index first. Any count 0: nothing.
struct Slab {
  std::vector<hsize_t> shape;  ///< of the whole dataset
  std::vector<hsize_t> start, count;
};

/// A new HDF5 file. Its content is collected first and written by commit(), so that errors cannot catch HDF5 half way
/// through a collective operation, where ranks would wait for each other for ever: rank 0 lays out the file alone,
/// with all small things in it, and reserves its space on the disk; then all ranks together fill the large datasets.
/// Names may contain groups ("vectors/state"), which are created.
class Hdf5Writer {
 public:
  Hdf5Writer(MPI_Comm comm, std::string path) : comm_(comm), path_(std::move(path)) {}

  /// Doubles, each rank its slab; `values` has the product of slab.count entries.
  void dataset(const std::string& name, Slab slab, std::vector<double> values);
  /// Doubles that all ranks know.
  void dataset(const std::string& name, std::vector<double> values);
  /// Text that all ranks know.
  void text(const std::string& name, const std::string& value) { texts_.push_back({"", name, value}); }
  /// Attribute of a dataset, or of "/" (the file).
  void attribute(const std::string& object, const std::string& name, double value);
  void attribute(const std::string& object, const std::string& name, const std::string& value);

  /// The file gets a seal, see seal.hpp.
  void seal() { sealed_ = true; }

  /// Collective. The file appears under its name complete, or not at all, leaving one of that name as it was; then
  /// std::runtime_error of one line on all ranks.
  void commit();

 private:
  struct Dataset {
    std::string name;
    Slab slab;
    std::vector<double> values;
  };
  struct Text {
    std::string object, name, value;
  };
  struct Number {
    std::string object, name;
    double value;
  };
  std::uintmax_t size_at_most() const;
  std::vector<ByteRange> lay_out(const std::string& path) const;
  void fill(const std::string& path) const;
  bool write_slab(hid_t file, const Dataset& dataset) const;

  MPI_Comm comm_;
  std::string path_;
  std::vector<Dataset> datasets_;
  std::vector<Text> texts_, text_attributes_;
  std::vector<Number> number_attributes_;
  bool sealed_ = false;
};

/// What went wrong innermost, by HDF5's current error stack, in one line; or "".
std::string hdf5_error();

}  // namespace scree
