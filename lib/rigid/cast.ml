let speed_bound = Speed.bound
let grid = Speed.grid

type outcome = Never | Inside | At of Scc_exact.Rat.t

let first_time_of_contact ?obstacle:_ _ _ ~span:_ ~grid:_ = Scc_base.Bug.fail __POS__ "not written yet"
