#define DOCTEST_CONFIG_IMPLEMENT // said here too, where what follows comes after doctest's declarations were read
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
