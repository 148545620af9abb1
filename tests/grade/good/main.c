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

// What the task for tests asks for: drives on where there is room.
int main(int argc, char** argv) {
  const int file = dial(argc > 1 ? atoi(argv[1]) : 4000);
  if (file < 0) return 8;
  ask(file, "d1 s1r.motion set_speed [0.3, 0.8]\n");
  for (int i = 0; i < 30; ++i) ask(file, "r ccmorse read\n");
  return 0;
}
