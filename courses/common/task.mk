# What the Makefiles of the course's tasks share. A task's Makefile sets NAME and OBJS, and includes
# this file:
#
#   make             builds NAME for the simulator
#   make MORSE=NO    builds NAME-syrotek for the real robot
#   make run         starts the program; ARGS="--offline" hands it options, ARGS=--help lists them
#   make clean       removes what was built, for both
#
# SOURCES, if set, are further folders of sources and headers, looked in after this one.

# - YES builds for the simulator,
# - anything else for the real robot (SyRoTek)
MORSE ?= YES

CXX ?= g++
CXXFLAGS ?= -O2 -g -Wall -Wextra

include $(dir $(lastword $(MAKEFILE_LIST)))ccmorse.mk

# $(strip): blanks behind the value must not send the program to the wrong robot.
ifeq ($(strip $(MORSE)),YES)
  PROGRAM = $(NAME)
  OBJDIR = obj-morse
  CPPFLAGS += -D _MORSE
  CPPFLAGS += $(CCMORSE_CPPFLAGS) $(IMRH_CPPFLAGS)
  LIBRARIES = $(CCMORSE_LDFLAGS) $(IMRH_LDFLAGS)
else
  PROGRAM = $(NAME)-syrotek
  OBJDIR = obj-syrotek
  CPPFLAGS += $(PLAH_CPPFLAGS) $(IMRH_CPPFLAGS)
  LIBRARIES = $(PLAH_LDFLAGS) $(IMRH_LDFLAGS)
endif
# A folder that is not there would be passed over in silence, and the next one's files be taken.
MISSING := $(strip $(foreach folder,$(SOURCES),$(if $(wildcard $(folder)/.),,$(folder))))
ifneq ($(MISSING),)
  $(error SOURCES in the Makefile names $(MISSING), which is not there: copy it beside this folder, too)
endif
CPPFLAGS += -I. $(addprefix -I,$(SOURCES))

vpath %.cc . $(SOURCES)

# Each platform has its own objects, so that the two never mix.
OBJPATHS = $(addprefix $(OBJDIR)/,$(OBJS))

all: $(PROGRAM)

# imr-h is a static library, so it comes before what it needs and after what needs it.
$(PROGRAM): $(OBJPATHS)
	$(CXX) $(CXXFLAGS) $(OBJPATHS) $(LIBRARIES) $(LDFLAGS) -o $@

# -MMD -MP note the headers of each object, and the include below reads these notes.
$(OBJDIR)/%.o: %.cc Makefile
	@mkdir -p $(OBJDIR)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) -MMD -MP -c $< -o $@

run: $(PROGRAM)
	./$(PROGRAM) $(RUN_ARGS) $(ARGS)

clean:
	rm -rf obj-morse obj-syrotek $(NAME) $(NAME)-syrotek

-include $(OBJPATHS:.o=.d)

.PHONY: all run clean
.DEFAULT_GOAL = all
