# Adds the suites of a GoogleTest program to CTest, one process a suite: what a suite's cases share is
# made once, and a process's start is paid for once.

# foveola_add_suites(PROGRAM NAME COST SLOW LONG)
#
# PROGRAM: its path. SLOW, LONG: filters of GoogleTest for the cases with the labels NAME-slow and
# NAME-long, the rest has the label NAME; their patterns begin with the name of a suite. Each test writes
# what became of its cases to cases/*.xml beside PROGRAM.
function(foveola_add_suites program name cost slow long)
  if(NOT EXISTS "${program}")
    add_test(${name} "${program}") # so that CTest says that it is not built
    return()
  endif()
  set(apart ${slow} ${long})
  string(JOIN ":" apart ${apart})
  foveola_suites(suites "${program}" "-${apart}")
  foreach(suite IN LISTS suites)
    foveola_patterns_of(patterns ${suite} "${apart}")
    foveola_add_suite("${program}" ${suite} "${suite}.*-${patterns}" ${name} ${cost})
  endforeach()
  foreach(kind slow long)
    foveola_suites(suites "${program}" "${${kind}}")
    foreach(suite IN LISTS suites)
      foveola_patterns_of(patterns ${suite} "${${kind}}")
      foveola_add_suite("${program}" ${suite} "${patterns}" ${name}-${kind} ${cost})
    endforeach()
  endforeach()
endfunction()

# The suites with a case that the filter selects: none for an empty filter.
function(foveola_suites result program filter)
  if(filter STREQUAL "")
    set(${result} "" PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND "${program}" --gtest_list_tests "--gtest_filter=${filter}"
                  TIMEOUT 120 OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
  # Cases are indented; a suite may have its type behind it.
  string(REGEX MATCHALL "\n[A-Za-z0-9_/]+\\." suites "\n${listed}")
  string(REGEX REPLACE "\n|\\." "" suites "${suites}")
  set(${result} "${suites}" PARENT_SCOPE)
endfunction()

# Of a filter's patterns, those of the suite.
function(foveola_patterns_of result suite filter)
  string(REPLACE ":" ";" patterns "${filter}")
  set(found "")
  foreach(pattern IN LISTS patterns)
    string(FIND "${pattern}" "${suite}." at)
    if(at EQUAL 0)
      list(APPEND found "${pattern}")
    endif()
  endforeach()
  string(JOIN ":" found ${found})
  set(${result} "${found}" PARENT_SCOPE)
endfunction()

function(foveola_add_suite program suite filter label cost)
  cmake_path(GET program PARENT_PATH folder)
  string(REPLACE "/" "-" file ${label}.${suite})
  add_test(${label}/${suite} "${program}" --gtest_brief=1 "--gtest_filter=${filter}"
           "--gtest_output=xml:${folder}/cases/${file}.xml")
  set_tests_properties(${label}/${suite} PROPERTIES LABELS ${label} COST ${cost} TIMEOUT 1800)
endfunction()
