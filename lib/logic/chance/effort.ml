open Scc_exact

type engine = Exactly | Nearly | Either

type t = {
  engine : engine;
  bits : int;
  steps : int;
  layers : int;
  width : Rat.t;
  relative : bool;
  bound : Answer.bound option;
  interrupted : unit -> bool;
  half : unit -> unit -> bool;
  quarter : unit -> unit -> bool;
  not_exact : Lifting.given_up -> unit;
}

let default =
  {
    engine = Either;
    bits = 200_000;
    steps = 1 lsl 30;
    layers = 20_000;
    width = Rat.make Z.one (Z.of_int 1_000_000);
    relative = false;
    bound = None;
    interrupted = (fun () -> false);
    half = (fun () () -> false);
    quarter = (fun () () -> false);
    not_exact = ignore;
  }

let most_layers e = 16 * e.layers
