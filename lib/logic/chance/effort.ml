open Scc_exact

type engine = Exactly | Nearly | Either

type t = {
  engine : engine;
  component : int;
  bits : int;
  width : Rat.t;
  relative : bool;
  bound : Answer.bound option;
  interrupted : unit -> bool;
}

let default =
  {
    engine = Either;
    component = 1_000;
    bits = 20_000;
    width = Rat.make Z.one (Z.of_int 1_000_000);
    relative = false;
    bound = None;
    interrupted = (fun () -> false);
  }
