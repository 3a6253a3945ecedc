# Everything that generated interfaces need at run time comes with their own packages.
