int tools();

int more()
{
  return tools() + 1;
}
