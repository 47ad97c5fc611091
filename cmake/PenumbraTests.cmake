# Common properties of tests: a timeout, and the exit status of a test that skipped all of its cases.
set(PENUMBRA_SKIPPED 77) # tests/support/Skips.h

# penumbra_test_cases(NAME FILE [ENVIRONMENT VARIABLE=VALUE...] [ARGUMENTS ...]): adds a Python file of unittest cases as a
# test.
function(penumbra_test_cases name file)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "ENVIRONMENT;ARGUMENTS")
  if(NOT Python3_EXECUTABLE)
    set(Python3_EXECUTABLE /usr/bin/python3)
  endif()
  add_test(NAME ${name}
    COMMAND "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/tests/support/run_cases.py" "${file}" ${arg_ARGUMENTS})
  set_tests_properties(${name} PROPERTIES
    ENVIRONMENT "PENUMBRA_CHECK_SHADERS=1;PENUMBRA_SPOIL_TEXTURES=1;PYTHONDONTWRITEBYTECODE=1;${arg_ENVIRONMENT}"
    FAIL_REGULAR_EXPRESSION "ERR\\|;WARN\\|"
    SKIP_RETURN_CODE ${PENUMBRA_SKIPPED}
    TIMEOUT ${PENUMBRA_TEST_TIMEOUT})
endfunction()
