// Never waits, and so never hears anything.
for (;;);
