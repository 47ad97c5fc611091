# Installs to an empty prefix, moves it, and uses it from a separate project and a script.
# cmake -DBUILD=... -DWORK=... -DCONSUMER=... -DPYTHON=... -DPYTHON_FOLDER=... -DTOOL=... -P run.cmake
function(step title)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${title} failed (${status}):\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
step("Installing" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/first")
file(RENAME "${WORK}/first" "${WORK}/moved")
set(prefix "${WORK}/moved")
step("Configuring the consumer" "${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${WORK}/consumer" -G Ninja
  "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_BUILD_TYPE=Release)
step("Building the consumer" "${CMAKE_COMMAND}" --build "${WORK}/consumer")
step("Running the consumer" "${WORK}/consumer/consumer")
if(PYTHON)
  step("Importing the Python package" "${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/${PYTHON_FOLDER}"
    "${PYTHON}" -c "import penumbra; assert penumbra.__file__.startswith('${prefix}'); penumbra.techniques()")
endif()
if(TOOL)
  step("Running the command" "${prefix}/bin/penumbra" --help)
endif()
file(REMOVE_RECURSE "${WORK}")
