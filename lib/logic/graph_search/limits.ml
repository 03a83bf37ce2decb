open Scc_exact

type t = {
  depth : int option;
  time : Rat.t option;
  instant : int option;
  states : int option;
  bits : int option;
}

let unlimited = { depth = None; time = None; instant = None; states = None; bits = None }

let too_long (t : t) ~longest ~bits =
  match t.bits with
  | None -> false
  | Some most -> longest > most && bits () > most

type progress =
  | Explored of { states : int; transitions : int; waiting : int; depth : int; model_time : Rat.t option Lazy.t }
  | Valued of { sets : int; all : int }

type stop = Seconds | Memory | Interrupted
type stage = Exploring | Proving | Concluding | Reporting
type attempt = { run : 'a. stage -> (unit -> 'a) -> ('a, stop) result }

type surroundings = {
  stop : unit -> stop option;
  half : unit -> surroundings;
  share : mine:int -> all:int -> surroundings;
  progress : progress -> unit;
  attempt : attempt;
}

let undivided ?(stop = fun () -> None) ?(attempt = { run = (fun _ f -> Ok (f ())) }) () =
  let rec all =
    { stop; attempt; progress = (fun _ -> ()); half = (fun () -> all); share = (fun ~mine:_ ~all:_ -> all) }
  in
  all

let quiet = undivided ()

exception Over of stop

let within around f =
  match around.attempt.run Exploring f with
  | Ok x -> x
  | Error stop -> raise (Over stop)
