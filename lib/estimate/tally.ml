open Scc_exact

type t = {
  runs : int;
  yes : int;
  no : int;
  free : int;
  too_long : int;
  never : int;
  no_value : int;
  why : string option;
  sum : Rat.t;
  squares : Rat.t;
}

let empty =
  {
    runs = 0; yes = 0; no = 0; free = 0; too_long = 0; never = 0; no_value = 0; why = None; sum = Rat.zero;
    squares = Rat.zero;
  }

let add t (o : Sample.outcome) =
  let t = { t with runs = t.runs + 1 } in
  match o with
  | Truth true -> { t with yes = t.yes + 1 }
  | Truth false -> { t with no = t.no + 1 }
  | Free -> { t with free = t.free + 1 }
  | Too_long -> { t with too_long = t.too_long + 1 }
  | Never -> { t with never = t.never + 1 }
  | No_value why -> { t with no_value = t.no_value + 1; why = (if t.why = None then Some why else t.why) }
  | Number x -> { t with sum = Rat.add t.sum x; squares = Rat.add t.squares (Rat.mul x x) }

let open_ended t = t.free + t.too_long + t.no_value
let numbers t = t.runs - t.yes - t.no - t.never - open_ended t

let likelihood t ~miss =
  let miss = Rat.div miss (Rat.of_int 2) in
  ( Clopper_pearson.lower ~n:t.runs ~k:t.yes ~miss,
    Clopper_pearson.upper ~n:t.runs ~k:(t.yes + open_ended t) ~miss )

(* The root of a number, rounded up to a multiple of 2^-64 of itself or so. *)
let root_above (r : Rat.t) =
  let shift = 64 + Int.max 0 (Z.numbits r.den) in
  let scaled = Z.cdiv (Z.shift_left r.num (2 * shift)) r.den in
  Rat.make (Z.succ (Z.sqrt scaled)) (Z.shift_left Z.one shift)

(* A rule of thumb for sums to be as good as normal. *)
let enough = 30

let mean t ~z =
  let n = numbers t in
  if n < enough then None
  else
    let count = Rat.of_int n in
    let mean = Rat.div t.sum count in
    let around = Rat.sub t.squares (Rat.mul t.sum mean) in
    let variance = Rat.div around (Rat.of_int (n - 1)) in
    let off = if Rat.sign variance = 0 then Rat.zero else Rat.mul z (root_above (Rat.div variance count)) in
    Some (mean, Rat.sub mean off, Rat.add mean off)
