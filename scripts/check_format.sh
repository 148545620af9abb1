# Fails and shows what to change where a file is not formatted as .clang-format says.
folders=$(ls -d include src courses tests benchmarks fuzz 2>/dev/null)
# shellcheck disable=SC2086  # a list of words
find $folders -name '*.h' -o -name '*.cpp' -o -name '*.cc' | xargs clang-format --dry-run --Werror --style=file
