# Wraps the module for Python as package "penumbra": build/python is ready to be put on PYTHONPATH.
set(PENUMBRA_PYTHON_DIR "${CMAKE_BINARY_DIR}/python")
vtk_module_wrap_python(
  MODULES ${_penumbra_modules}
  TARGET Penumbra::Python
  INSTALL_EXPORT Penumbra
  PYTHON_PACKAGE "penumbra"
  MODULE_DESTINATION "python"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)
