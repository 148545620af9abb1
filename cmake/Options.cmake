# What every target of ours is compiled with. The determinism promise rests on -ffp-contract=off
# (docs/architecture.md): a fused multiply-add would round differently from one machine to the next.
add_library(ccmorse_options INTERFACE)
target_compile_options(ccmorse_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual -Werror -ffp-contract=off
  -Wno-restrict)  # GCC 12 warns of std::string's own assignments at -O3 (its bug 105651)
target_include_directories(ccmorse_options INTERFACE
  ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
if(CCMORSE_SANITIZE)
  # GCC 12 takes the sanitizers' own instrumentation for uninitialised use.
  target_compile_options(ccmorse_options INTERFACE -fsanitize=${CCMORSE_SANITIZE}
    -fno-sanitize-recover=all -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  target_link_options(ccmorse_options INTERFACE -fsanitize=${CCMORSE_SANITIZE})
endif()
if(CCMORSE_SANITIZE MATCHES undefined)
  # These look at every access and take half of the compiler's time. The address sanitizer sees null
  # pointers and what lies beyond an object as well; src/wire, which reads foreign bytes, checks
  # alignment nevertheless.
  target_compile_options(ccmorse_options INTERFACE -fno-sanitize=null,alignment,object-size)
endif()
if(CCMORSE_SANITIZE MATCHES thread)
  # Asio's fences are what the thread sanitizer does not understand; its locks do the work.
  target_compile_definitions(ccmorse_options INTERFACE BOOST_ASIO_DISABLE_FENCED_BLOCK)
endif()

# Several files as one: the headers, which are most of a small file, are read once for all of them,
# and a build takes a third of the time. Names within anonymous namespaces have to differ within a
# target, therefore.
option(CCMORSE_UNITY "Compile several source files as one" ON)
set(CMAKE_UNITY_BUILD ${CCMORSE_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
if(CCMORSE_UNITY)
  # To the compiler each file but the unit itself looks like a header, whose classes should hold
  # nothing from anonymous namespaces.
  target_compile_options(ccmorse_options INTERFACE -Wno-subobject-linkage)
endif()

# ccmorse_library(NAME sources...): one folder of src/ as a static library with our options.
function(ccmorse_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PRIVATE ccmorse_options)
endfunction()

# ccmorse_test(NAME sources... LIBRARIES libs...): one GoogleTest program; ctest lists every case by
# its own name, so that `ctest -N` shows which requirement ids are verified.
function(ccmorse_test name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ccmorse_options ${ARG_LIBRARIES} GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE
    CCMORSE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CCMORSE_BINARY_DIR="${PROJECT_BINARY_DIR}")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 120)
endfunction()

# ccmorse_user_program(NAME sources...): a program as users build theirs, over the public headers
# only and with their flags; the sanitizers of this build have to be in every part of a program.
function(ccmorse_user_program name)
  add_executable(${name} ${ARGN})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Werror)
  if(CCMORSE_SANITIZE)
    target_compile_options(${name} PRIVATE -fsanitize=${CCMORSE_SANITIZE})
    target_link_options(${name} PRIVATE -fsanitize=${CCMORSE_SANITIZE})
  endif()
endfunction()
