extern "C" int stick(int a) {return a + 1;}
