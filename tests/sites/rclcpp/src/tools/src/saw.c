int version = 7;

const char * name(void) {return "saw";}

double use(int a, double b) {return a - b;}

float half(float a, long long b) {return a / 2 + b;}
