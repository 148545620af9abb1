// Prints the map as text: '#' occupied, '.' free, blank unknown.
//   ./map_viewer [host [port [index]]]

#include <libplayerc++/playerc++.h>

using namespace PlayerCc;

int main(int argc, char** argv) {
  const std::string host = argc > 1 ? argv[1] : PLAYER_HOSTNAME;
  const int port = argc > 2 ? atoi(argv[2]) : PLAYER_PORTNUM;
  const int index = argc > 3 ? atoi(argv[3]) : 0;
  const int columns = 78;
  try {
    PlayerClient robot(host, port);
    MapProxy map(&robot, index);
    map.RequestMap();
    const int width = map.GetWidth();
    const int height = map.GetHeight();
    std::cout << width << " x " << height << " cells of " << map.GetResolution() << " m, from "
              << map.GetOriginX() << ", " << map.GetOriginY() << std::endl;
    // A character stands for a block of cells, twice as high as wide, as characters are.
    const int step = (width + columns - 1) / columns > 0 ? (width + columns - 1) / columns : 1;
    for (int top = height; top > 0; top -= 2 * step) {
      std::string line;
      for (int left = 0; left < width; left += step) {
        char shown = ' ';
        for (int y = top - 1; y >= 0 && y >= top - 2 * step; --y) {
          for (int x = left; x < width && x < left + step; ++x) {
            const int cell = map.GetCell(x, y);
            if (cell > 0) shown = '#';
            if (cell < 0 && shown == ' ') shown = '.';
          }
        }
        line += shown;
      }
      std::cout << line << "\n";
    }
  } catch (PlayerError& error) {
    std::cerr << error << std::endl;
    return 1;
  }
  return 0;
}
