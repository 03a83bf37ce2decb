open Scc_exact
open Scc_verify

type t = {
  depth : int option;
  time : Rat.t option;
  states : int option;
  seconds : float option;
  memory : int option;
  bits : int option;
}

type defaults = { states : int; memory : int; room : int option }

let bounds (defaults : defaults) (b : t) =
  let given = function Some x -> Bounds.Given x | None -> Bounds.Unbounded in
  let or_default default = function Some x -> Bounds.Given x | None -> Bounds.Default default in
  {
    Bounds.default with
    depth = given b.depth;
    time = given b.time;
    states = or_default defaults.states b.states;
    seconds = given b.seconds;
    memory = or_default defaults.memory b.memory;
    room = defaults.room;
    bits = (match b.bits with Some n -> Given n | None -> Bounds.default.bits);
  }
