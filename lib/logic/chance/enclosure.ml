open Scc_exact

exception Enough

type t = {
  e : Equations.t;
  effort : Effort.t;
  r : Rounded.t;
  asked : int array;
  near_width : float;  (** a little less than the width asked for *)
  direct : Direct.t;
  mutable steps : Rounded.t option;  (** made when it is first used *)
  proper : bool;
  few : bool;  (** so few are asked for that to look at them costs nothing *)
  mutable fresh : bool;  (** whether this is the first pass, and guesses are no better than bounds *)
  mutable work : int;  (** nodes that were looked at *)
  mutable next : int;  (** the work at which the next question is due whether to go on *)
}

let stride = 100_000

(* So many products of floats are made however little time there is, since they take a tenth of a second. *)
let in_any_case = 1 lsl 24

(* Whether the interval of a node is so narrow that floats show it: they err by less than 2^-40 of a number that
   is not tiny. *)
let clearly_narrow t v =
  let low = t.r.lower.(v) in
  let width = if t.effort.relative then t.near_width *. low else t.near_width in
  width > 1e-250 && t.r.upper.(v) -. low <= width

(* Whether the interval of a node is good enough, exactly. *)
let good t v =
  clearly_narrow t v
  ||
  let low, high = Rounded.interval t.r v in
  let decided () =
    match t.effort.bound with
    | None -> false
    | Some bound ->
      let a : Answer.t = match high with None -> At_least low | Some high -> Within (low, high) in
      Option.is_some (Answer.holds a bound)
  in
  match high with
  | None -> decided ()
  | Some high ->
    let width = if t.effort.relative then Rat.mul t.effort.width low else t.effort.width in
    Rat.compare (Rat.sub high low) width <= 0 || decided ()

let worked t n =
  t.work <- t.work + n;
  if t.work >= t.next then begin
    t.next <- t.work + stride;
    if t.effort.interrupted () || (t.few && Array.for_all (good t) t.asked) then raise Enough
  end

type part = { first : int; last : int }

let size part = part.last - part.first + 1

let start (e : Equations.t) (effort : Effort.t) ~upper ~asked =
  let entries = Equations.first_entry e (Equations.first_row e e.size) in
  {
    e;
    effort;
    r = Rounded.start e ~upper;
    asked;
    near_width = Rat.to_float effort.width *. (1. -. 0x1p-40);
    direct = Direct.room ();
    steps = None;
    proper = (match e.direction with Max -> true | Min -> upper < infinity);
    few = Array.length asked <= 16;
    fresh = true;
    work = 0;
    next = Int.max stride (in_any_case / (1 + (entries / Int.max 1 e.size)));
  }
