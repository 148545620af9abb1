# Fails and shows what to change when a file is not formatted as .clang-format says.
git ls-files '*.h' '*.cpp' '*.cc' | xargs clang-format --dry-run --Werror --style=file
