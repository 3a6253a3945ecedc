// Dies of an exception.
throw new RangeError("no such wheel");
