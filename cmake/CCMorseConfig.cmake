# CCMorse for programs that are built with CMake:
#
#   find_package(CCMorse REQUIRED)
#   ccmorse_add_program(robot robot.cc)    # robot for the simulator, robot-syrotek for the real one
#
# It is found where it is installed, or with HINTS $ENV{CCMORSE_DIR} in a source tree, whose
# libraries are those of build/release; -D CCMORSE_LIBDIR=FOLDER chooses another build's.
#
# Targets, for what is not one of the course's programs: CCMorse::CCMorse, the client library, and
# CCMorse::imrh, the course's support library.

include(CMakeFindDependencyMacro)
find_dependency(Threads)

# In the project itself both are targets already.
if(NOT TARGET CCMorse::CCMorse)
  foreach(up .. ../../.. ../../../..)
    get_filename_component(ccmorse_root "${CMAKE_CURRENT_LIST_DIR}/${up}" ABSOLUTE)
    if(EXISTS ${ccmorse_root}/include/libCCMorse/CCMorse.h)
      break()
    endif()
  endforeach()
  if(NOT CCMORSE_LIBDIR)
    file(GLOB ccmorse_libraries ${ccmorse_root}/build/release/lib/libCCMorse.so
      ${ccmorse_root}/lib/*/libCCMorse.so ${ccmorse_root}/lib/libCCMorse.so)
    if(ccmorse_libraries)
      list(GET ccmorse_libraries 0 ccmorse_library)
      get_filename_component(CCMORSE_LIBDIR ${ccmorse_library} DIRECTORY)
    endif()
  endif()
  if(NOT EXISTS ${ccmorse_root}/include/libCCMorse/CCMorse.h OR
      NOT EXISTS "${CCMORSE_LIBDIR}/libCCMorse.so")
    set(CCMorse_FOUND FALSE)
    set(CCMorse_NOT_FOUND_MESSAGE
      "libCCMorse.so is not in ${ccmorse_root}: build it (./demo does), install it, or set CCMORSE_LIBDIR")
    return()
  endif()
  add_library(CCMorse::CCMorse SHARED IMPORTED)
  set_target_properties(CCMorse::CCMorse PROPERTIES IMPORTED_LOCATION ${CCMORSE_LIBDIR}/libCCMorse.so
    INTERFACE_INCLUDE_DIRECTORIES ${ccmorse_root}/include)
  add_library(CCMorse::imrh STATIC IMPORTED)
  set_target_properties(CCMorse::imrh PROPERTIES IMPORTED_LOCATION ${CCMORSE_LIBDIR}/libimrh.a
    INTERFACE_INCLUDE_DIRECTORIES ${ccmorse_root}/include INTERFACE_LINK_LIBRARIES Threads::Threads)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE RelWithDebInfo)
  endif()
endif()

# ccmorse_add_program(NAME SOURCE... [FOLDERS FOLDER...]): makes NAME for the simulator, and
# NAME-syrotek from the same sources for the real robot. A source that is not here is taken from the
# first of FOLDERS that has it; headers are looked for in the same places.
function(ccmorse_add_program name)
  cmake_parse_arguments(program "" "" "FOLDERS" ${ARGN})
  set(sources)
  foreach(source IN LISTS program_UNPARSED_ARGUMENTS)
    set(found)
    foreach(folder . ${program_FOLDERS})
      if(NOT found AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${source})
        set(found ${folder}/${source})
      endif()
    endforeach()
    if(NOT found)
      message(FATAL_ERROR "${name}: there is no ${source} in this folder, nor in ${program_FOLDERS}")
    endif()
    list(APPEND sources ${found})
  endforeach()
  foreach(platform "" -syrotek)
    add_executable(${name}${platform} ${sources})
    target_include_directories(${name}${platform} PRIVATE . ${program_FOLDERS})
    target_link_libraries(${name}${platform} PRIVATE CCMorse::imrh CCMorse::CCMorse)
  endforeach()
  target_compile_definitions(${name} PRIVATE _MORSE)
endfunction()
