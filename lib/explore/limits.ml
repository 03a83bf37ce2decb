open Scc_exact

type t = {
  depth : int option;
  time : Rat.t option;
  instant : int option;
  states : int option;
  seconds : float option;
  memory : int option;
}

let unlimited = { depth = None; time = None; instant = None; states = None; seconds = None; memory = None }

type progress = { states : int; transitions : int; waiting : int; depth : int; model_time : Rat.t }

type attempt = { run : 'a. (unit -> 'a) -> 'a option }

type surroundings = {
  now : unit -> float;
  interrupted : unit -> bool;
  progress : progress -> unit;
  ended : unit -> unit;
  attempt : attempt;
}

let quiet =
  {
    now = (fun () -> 0.);
    interrupted = (fun () -> false);
    progress = (fun _ -> ());
    ended = (fun () -> ());
    attempt = { run = (fun f -> Some (f ())) };
  }
