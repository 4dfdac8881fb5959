#include "scree/output/hdf5_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "scree/output/atomic_file.hpp"
#include "scree/output/errors.hpp"

namespace scree {

namespace {

/// Passes an identifier or status of HDF5 on; throws std::runtime_error if it means failure.
hid_t checked(hid_t result) {
  if (result >= 0) return result;
  const std::string error = hdf5_error();
  throw std::runtime_error(error.empty() ? "HDF5 failed" : error);
}

bool is_empty(const Slab& slab) {
  for (const hsize_t count : slab.count) {
    if (count == 0) return true;
  }
  return false;
}

Hdf5Handle text_type(const std::string& value) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), std::max<size_t>(1, value.size()));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

void write_attribute(hid_t file, const std::string& object, const std::string& name, hid_t type, const void* value) {
  const Hdf5Handle owner(checked(H5Oopen(file, object.c_str(), H5P_DEFAULT)), H5Oclose),
      space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(checked(H5Acreate2(owner.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT)),
                             H5Aclose);
  checked(H5Awrite(attribute.id(), type, value));
}

/// Gives a file (new or not) blocks for `size` bytes, so that a full disk shows here and not inside HDF5.
void reserve_space(const std::string& path, std::uintmax_t size) {
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT, 0666);
  int code = descriptor < 0 ? errno : posix_fallocate(descriptor, 0, static_cast<off_t>(size));
  if (descriptor >= 0 && close(descriptor) != 0 && code == 0) code = errno;
  if (code != 0) throw std::runtime_error(std::strerror(code));
}

}  // namespace

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
  close();
  id_ = other.id_;
  closer_ = other.closer_;
  other.id_ = -1;
  return *this;
}

bool Hdf5Handle::close() {
  if (id_ < 0) return true;
  const bool ok = closer_(id_) >= 0;
  id_ = -1;
  return ok;
}

// OMPIO guards a shared file pointer, which HDF5 does not use, by a semaphore that is named after the last part of the
// file's name alone (its sharedfp/sm). A run that is killed while it holds the semaphore leaves it locked, and every
// later run on that machine waits for ever when it opens a file of that name. ROMIO makes nothing until the pointer is
// used.
Hdf5Handle shared_access(MPI_Comm comm) {
  setenv("OMPI_MCA_io_ompio_priority", "1", 0);  // read at the first opening; below ROMIO's 10
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_mpio(access.id(), comm, MPI_INFO_NULL);
  return access;
}

QuietHdf5::QuietHdf5() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietHdf5::~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

std::string hdf5_error() {
  std::string message;
  const auto take_first = [](unsigned, const H5E_error2_t* error, void* data) -> herr_t {
    auto* text = static_cast<std::string*>(data);
    if (text->empty() && error->desc) *text = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &message);
  const std::string mark = "error message = '";  // of the system, amid a long account of the call
  const size_t system = message.find(mark);
  if (system != std::string::npos) {
    const size_t begin = system + mark.size();
    return message.substr(begin, message.find('\'', begin) - begin);
  }
  return message.substr(0, message.find('\n'));
}

void Hdf5Writer::dataset(const std::string& name, Slab slab, std::vector<double> values) {
  datasets_.push_back({name, std::move(slab), std::move(values)});
}

void Hdf5Writer::dataset(const std::string& name, std::vector<double> values) {
  int rank = 0;
  MPI_Comm_rank(comm_, &rank);
  const hsize_t size = values.size();
  dataset(name, Slab{{size}, {0}, {rank == 0 ? size : 0}}, std::move(values));
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, double value) {
  number_attributes_.push_back({object, name, value});
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, const std::string& value) {
  text_attributes_.push_back({object, name, value});
}

void Hdf5Writer::commit() {
  const QuietHdf5 quiet;
  const std::string temporary = temporary_name(path_);
  std::vector<ByteRange> numbers;
  try {
    on_first_rank(comm_, [&] {
      reserve_space(temporary, size_at_most());  // HDF5 1.10 does not survive a failure to close a file
      numbers = lay_out(temporary);
      reserve_space(temporary, std::filesystem::file_size(temporary));
    });
    fill(temporary);
    on_first_rank(comm_, [&] {
      if (sealed_) write_seal(temporary, numbers);
      move_into_place(temporary, path_);
    });
  } catch (const std::runtime_error& error) {
    int rank = 0;
    MPI_Comm_rank(comm_, &rank);
    if (rank == 0) std::remove(temporary.c_str());
    throw std::runtime_error("cannot write '" + path_ + "': " + error.what());
  }
}

/// Bytes of the file, rather too many.
std::uintmax_t Hdf5Writer::size_at_most() const {
  constexpr std::uintmax_t frame = 65536, per_object = 4096;
  std::uintmax_t size = frame + per_object * (datasets_.size() + texts_.size() + text_attributes_.size());
  for (const Dataset& dataset : datasets_) {
    std::uintmax_t entries = 1;
    for (const hsize_t count : dataset.slab.shape) entries *= count;
    size += entries * sizeof(double);
  }
  for (const Text& text : texts_) size += text.value.size();
  return size;
}

/// All but the values of the datasets, whose places in the file are returned. One rank, without MPI-IO.
std::vector<ByteRange> Hdf5Writer::lay_out(const std::string& path) const {
  std::vector<ByteRange> numbers;
  const Hdf5Handle form(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  if (sealed_) H5Pset_userblock(form.id(), seal_size);
  Hdf5Handle file(checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, form.id(), H5P_DEFAULT)), H5Fclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose), links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_alloc_time(creation.id(), H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(creation.id(), H5D_FILL_TIME_NEVER);
  H5Pset_create_intermediate_group(links.id(), 1);
  for (const Dataset& dataset : datasets_) {
    const std::vector<hsize_t>& shape = dataset.slab.shape;
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
    Hdf5Handle data(checked(H5Dcreate2(file.id(), dataset.name.c_str(), H5T_IEEE_F64LE, space.id(), links.id(),
                                       creation.id(), H5P_DEFAULT)),
                    H5Dclose);
    const haddr_t place = H5Dget_offset(data.id());
    if (place != HADDR_UNDEF) numbers.push_back({place, H5Dget_storage_size(data.id())});
    checked(data.close() ? 0 : -1);
  }
  const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  for (const Text& text : texts_) {
    const Hdf5Handle type = text_type(text.value);
    const Hdf5Handle data(
        checked(H5Dcreate2(file.id(), text.name.c_str(), type.id(), scalar.id(), links.id(), H5P_DEFAULT, H5P_DEFAULT)),
        H5Dclose);
    checked(H5Dwrite(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.value.c_str()));
  }
  for (const Text& text : text_attributes_) {
    write_attribute(file.id(), text.object, text.name, text_type(text.value).id(), text.value.c_str());
  }
  for (const Number& number : number_attributes_) {
    write_attribute(file.id(), number.object, number.name, H5T_NATIVE_DOUBLE, &number.value);
  }
  checked(file.close() ? 0 : -1);
  std::sort(numbers.begin(), numbers.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
  return numbers;
}

/// The values of the datasets. Collective; changes nothing but the space that lay_out() has made for them.
void Hdf5Writer::fill(const std::string& path) const {
  const Hdf5Handle access = shared_access(comm_);
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.id()), H5Fclose);
  agree(comm_, file.valid(), hdf5_error());
  bool ok = true;
  std::string error;
  for (const Dataset& dataset : datasets_) {
    if (write_slab(file.id(), dataset)) continue;
    if (ok) error = hdf5_error();
    ok = false;  // and on with the others: all ranks make the same calls
  }
  if (!file.close() && ok) {
    error = hdf5_error();
    ok = false;
  }
  agree(comm_, ok, error);
}

bool Hdf5Writer::write_slab(hid_t file, const Dataset& dataset) const {
  const Slab& slab = dataset.slab;
  const Hdf5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_dxpl_mpio(transfer.id(), H5FD_MPIO_COLLECTIVE);
  const Hdf5Handle data(H5Dopen2(file, dataset.name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(data.id()), H5Sclose);
  const Hdf5Handle memory(H5Screate_simple(static_cast<int>(slab.count.size()), slab.count.data(), nullptr), H5Sclose);
  if (is_empty(slab)) {
    H5Sselect_none(space.id());
    H5Sselect_none(memory.id());
  } else {
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, slab.start.data(), nullptr, slab.count.data(), nullptr);
  }
  const double nothing = 0;
  const double* values = dataset.values.empty() ? &nothing : dataset.values.data();
  return H5Dwrite(data.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), transfer.id(), values) >= 0;
}

}  // namespace scree
