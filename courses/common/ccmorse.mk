# Where CCMorse and its support library are, for the Makefiles of the course's programs.
#
# Looked for in this order:
#   1. CCMORSE_DIR, if it is set: a source tree, or the folder that CCMorse was installed under;
#   2. the installed tree that this file is part of;
#   3. what `pkg-config ccmorse` finds, if CCMorse is installed;
#   4. the source tree that this file is part of.
# A source tree's libraries are taken from build/release/lib; set CCMORSE_LIBDIR for another build.
#
# Sets, in the names that the course's Makefiles have always used:
#   CCMORSE_CPPFLAGS CCMORSE_LDFLAGS   the client library for the simulator
#   PLAH_CPPFLAGS PLAH_LDFLAGS         the same library under the names of the real robot's headers
#   IMRH_CPPFLAGS IMRH_LDFLAGS         the support library imr-h
#   BOOST_CPPFLAGS BOOST_LDFLAGS       empty: no program needs Boost any more
#   OBJSPLAH                           empty: no further object is needed on the real robot

CCMORSE_MK_DIR := $(dir $(abspath $(lastword $(MAKEFILE_LIST))))

ifeq ($(strip $(CCMORSE_DIR)),)
  ifneq ($(wildcard $(CCMORSE_MK_DIR)../../../../include/libCCMorse/CCMorse.h),)
    CCMORSE_DIR := $(abspath $(CCMORSE_MK_DIR)../../../..)
  endif
endif
ifeq ($(strip $(CCMORSE_DIR)),)
  ifeq ($(shell pkg-config --exists ccmorse 2>/dev/null && echo yes),yes)
    CCMORSE_INCLUDEDIR := $(shell pkg-config --variable=includedir ccmorse)
    CCMORSE_LIBDIR ?= $(shell pkg-config --variable=libdir ccmorse)
  else
    CCMORSE_DIR := $(abspath $(CCMORSE_MK_DIR)../..)
  endif
endif

ifneq ($(strip $(CCMORSE_DIR)),)
  CCMORSE_INCLUDEDIR := $(strip $(CCMORSE_DIR))/include
  # The first folder that holds the library; before the first build, where it will be.
  CCMORSE_LIBDIR ?= $(firstword $(patsubst %/,%,$(dir $(wildcard \
    $(strip $(CCMORSE_DIR))/build/release/lib/libCCMorse.so \
    $(strip $(CCMORSE_DIR))/lib/*/libCCMorse.so \
    $(strip $(CCMORSE_DIR))/lib/libCCMorse.so))) \
    $(strip $(CCMORSE_DIR))/build/release/lib)
endif

ifeq ($(wildcard $(CCMORSE_INCLUDEDIR)/libCCMorse/CCMorse.h),)
  $(warning CCMorse is not in $(CCMORSE_INCLUDEDIR); set CCMORSE_DIR to its source tree or to where \
    it is installed: make CCMORSE_DIR=/path/to/ccmorse)
endif

# The run-time path lets a program find the library without LD_LIBRARY_PATH.
CCMORSE_CPPFLAGS := -I$(CCMORSE_INCLUDEDIR)
CCMORSE_LDFLAGS := -L$(CCMORSE_LIBDIR) -Wl,-rpath,$(CCMORSE_LIBDIR) -lCCMorse

PLAH_CPPFLAGS := $(CCMORSE_CPPFLAGS)
PLAH_LDFLAGS := $(CCMORSE_LDFLAGS)
OBJSPLAH :=

IMRH_CPPFLAGS := -I$(CCMORSE_INCLUDEDIR)
IMRH_LDFLAGS := -L$(CCMORSE_LIBDIR) -limrh -pthread

BOOST_CPPFLAGS :=
BOOST_LDFLAGS :=
