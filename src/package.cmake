# What is installed, and the Debian package: cpack -G DEB in the build directory. Build for others with
# -DSCREE_NATIVE=OFF.
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY TRUE)  # build.sh scree is enough
install(TARGETS scree)
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/scree)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The Python package where Debian's python3 looks, and its commands.
set(SCREE_PYTHON_DESTINATION lib/python3/dist-packages CACHE STRING "Where the Python package is installed")
install(DIRECTORY scripts/scree DESTINATION ${SCREE_PYTHON_DESTINATION} PATTERN __pycache__ EXCLUDE)
install(PROGRAMS scripts/scree-sweep scripts/scree-report TYPE BIN)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME scree)
set(CPACK_PACKAGE_VENDOR scree)
set(CPACK_PACKAGE_CONTACT "Scree maintainers <maintainers@scree.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "openmpi-bin, python3, python3-numpy, python3-scipy, python3-matplotlib, python3-h5py, \
python3-xarray, python3-pandas, python3-yaml, python3-pil")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Silos that empty, beds that bubble, heaps that settle: grains and gas as two \
continua, solved implicitly and in parallel. With its cases, and the Python package that runs it and opens what it leaves.")
include(CPack)
