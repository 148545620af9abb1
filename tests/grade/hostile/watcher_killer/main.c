#include <arpa/inet.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

// A connection to 127.0.0.1, or -1.
static int dial(int port) {
  struct sockaddr_in to;
  memset(&to, 0, sizeof to);
  to.sin_family = AF_INET;
  to.sin_port = htons((unsigned short)port);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int file = socket(AF_INET, SOCK_STREAM, 0);
  if (connect(file, (struct sockaddr*)&to, sizeof to) == 0) return file;
  close(file);
  return -1;
}

// Sends a line and waits for a line.
static void ask(int file, const char* line) {
  char answer[65536];
  if (write(file, line, strlen(line)) < 0) exit(9);
  for (;;) {
    const ssize_t size = read(file, answer, sizeof answer - 1);
    if (size <= 0) exit(9);
    answer[size] = 0;
    if (strlen(answer) < 300) fputs(answer, stdout);
    if (answer[size - 1] == '\n') return;
  }
}

#include <fcntl.h>
#include <signal.h>
#include <sys/ptrace.h>

// Tries to end or to enter the process that watches it, and to write where nobody may.
int main(int argc, char** argv) {
  (void)argc;
  (void)argv;
  kill(1, SIGKILL);
  kill(1, SIGTERM);
  kill(1, SIGSTOP);
  if (ptrace(PTRACE_ATTACH, 1, 0, 0) == 0) return 42;
  if (open("/proc/1/mem", O_RDWR) >= 0) return 43;
  if (open("main.c", O_WRONLY) >= 0) return 44;
  if (open("/usr/left", O_CREAT | O_WRONLY, 0600) >= 0) return 45;
  if (open("/dev/left", O_CREAT | O_WRONLY, 0600) >= 0) return 46;
  return 7;
}
