exception Exhausted

type t = { stop : unit -> bool; mutable steps : int }

(* Steps between two questions: well under a tenth of a second. *)
let interval = 100_000
let make ~stop = { stop; steps = 0 }
let unlimited () = make ~stop:(fun () -> false)

let spend t n =
  t.steps <- t.steps + n;
  if t.steps >= interval then begin
    t.steps <- 0;
    if t.stop () then raise Exhausted
  end
