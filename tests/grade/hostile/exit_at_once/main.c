// Ends before it has done anything.
int main(void) { return 0; }
