open Scc_base
open Scc_exact

type t = {
  runs : int;
  yes : int;
  no : int;
  free : int;
  bounces : int;
  too_long : int;
  bounds : Sample.bound list;
  never : int;
  no_value : int;
  why : string option;
  numbers : int;
  sum : Rat.t;
  squares : Rat.t;
}

let empty =
  {
    runs = 0; yes = 0; no = 0; free = 0; bounces = 0; too_long = 0; bounds = []; never = 0; no_value = 0;
    why = None; numbers = 0; sum = Rat.zero; squares = Rat.zero;
  }

let add t (o : Sample.outcome) =
  let t = { t with runs = t.runs + 1 } in
  match o with
  | Truth true -> { t with yes = t.yes + 1 }
  | Truth false -> { t with no = t.no + 1 }
  | Free Elsewhere -> { t with free = t.free + 1 }
  | Free Walkers_bounce -> { t with free = t.free + 1; bounces = t.bounces + 1 }
  | Too_long bound ->
    let bounds = if List.mem bound t.bounds then t.bounds else List.sort Stdlib.compare (bound :: t.bounds) in
    { t with too_long = t.too_long + 1; bounds }
  | Never -> { t with never = t.never + 1 }
  | No_value why -> { t with no_value = t.no_value + 1; why = (if t.why = None then Some why else t.why) }
  | Number x ->
    { t with numbers = t.numbers + 1; sum = Rat.add t.sum x; squares = Rat.add t.squares (Rat.mul x x) }

let open_ended t = t.free + t.too_long + t.no_value

let likelihood t ~miss =
  let miss = Rat.mul Rat.half miss in
  ( Clopper_pearson.lower ~n:t.runs ~k:t.yes ~miss,
    Clopper_pearson.upper ~n:t.runs ~k:(t.yes + open_ended t) ~miss )

(* More than e. *)
let e_above = Rat.make (Z.of_int 271_829) (Z.of_int 100_000)

let mean t (range : Range.t) ~miss =
  let width = Rat.sub range.high range.low in
  if Rat.sign width = 0 then (range.low, range.low)
  else begin
    let miss = Rat.div miss (if range.ends_only then Rat.of_int 2 else Rat.mul (Rat.of_int 2) e_above) in
    let least = Rat.div (Rat.sub t.sum (Rat.mul (Rat.of_int t.numbers) range.low)) width in
    let most = Rat.add least (Rat.of_int (open_ended t)) in
    if Rat.sign least < 0 || Rat.compare most (Rat.of_int t.runs) > 0 then
      Bug.fail __POS__ "a number beyond its range";
    (* Whole numbers, of which the bound is proved: fewer below, more above. *)
    let below = Z.to_int (Rat.floor least) and above = Z.to_int (Z.neg (Rat.floor (Rat.neg most))) in
    let at share = Rat.add range.low (Rat.mul share width) in
    ( at (Clopper_pearson.lower ~n:t.runs ~k:below ~miss),
      at (Clopper_pearson.upper ~n:t.runs ~k:above ~miss) )
  end

let spread t =
  if t.numbers = 0 then None
  else
    let mean = Rat.div t.sum (Rat.of_int t.numbers) in
    let around = Rat.sub t.squares (Rat.mul t.sum mean) in
    let deviation =
      if t.numbers = 1 then None else Some (Rat.root (Rat.div around (Rat.of_int (t.numbers - 1))))
    in
    Some (mean, deviation)
