const char * name(void);

const char * call_name(void) {return name();}
