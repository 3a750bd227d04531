"""How fast a lap can be, and how near to it the planner's laps come."""
