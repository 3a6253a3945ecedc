extern "C" const char * name();

int length() {return 100;}

extern "C" const char * call_name() {return name();}
