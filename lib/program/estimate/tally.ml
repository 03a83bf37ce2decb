open Scc_base
open Scc_exact
module Values = Map.Make (Rat)

type t = {
  runs : int;
  yes : int;
  no : int;
  free : int;
  bounces : int;
  splits : int;
  too_long : int;
  bounds : Sample.bound list;
  never : int;
  no_value : int;
  why : string option;
  numbers : int;
  sum : Rat.t;
  squares : Rat.t;
  values : int Values.t;
}

let empty =
  {
    runs = 0; yes = 0; no = 0; free = 0; bounces = 0; splits = 0; too_long = 0; bounds = []; never = 0;
    no_value = 0; why = None; numbers = 0; sum = Rat.zero; squares = Rat.zero; values = Values.empty;
  }

let add t (o : Sample.outcome) =
  let t = { t with runs = t.runs + 1 } in
  match o with
  | Truth true -> { t with yes = t.yes + 1 }
  | Truth false -> { t with no = t.no + 1 }
  | Free Elsewhere -> { t with free = t.free + 1 }
  | Free Walkers_bounce -> { t with free = t.free + 1; bounces = t.bounces + 1 }
  | Free Splits -> { t with free = t.free + 1; splits = t.splits + 1 }
  | Too_long bound ->
    let bounds = if List.mem bound t.bounds then t.bounds else List.sort Stdlib.compare (bound :: t.bounds) in
    { t with too_long = t.too_long + 1; bounds }
  | Never -> { t with never = t.never + 1 }
  | No_value why -> { t with no_value = t.no_value + 1; why = (if t.why = None then Some why else t.why) }
  | Number x ->
    let values = Values.update x (fun n -> Some (Option.value n ~default:0 + 1)) t.values in
    { t with numbers = t.numbers + 1; sum = Rat.add t.sum x; squares = Rat.add t.squares (Rat.mul x x); values }

let open_ended t = t.free + t.too_long + t.no_value

let likelihood t ~miss =
  let miss = Rat.mul Rat.half miss in
  ( Clopper_pearson.lower ~n:t.runs ~k:t.yes ~miss,
    Clopper_pearson.upper ~n:t.runs ~k:(t.yes + open_ended t) ~miss )

let of_share t ~low ~high ~miss =
  let least = Rat.div (Rat.sub t.sum (Rat.mul (Rat.of_int t.numbers) low)) (Rat.sub high low) in
  let yes = Z.to_int (Rat.floor least) and at share = Rat.add low (Rat.mul share (Rat.sub high low)) in
  let low, high = likelihood { t with yes } ~miss in
  (at low, at high)

let mean t (range : Range.t) ~look ~miss =
  let beyond x = Bug.fail __POS__ ("beyond its range: " ^ Rat.to_string x) in
  let bound distance =
    let value (x, n) =
      let d = distance x in
      if Rat.sign d < 0 then beyond x else if Rat.sign d = 0 then None else Some (d, n)
    in
    let values = List.filter_map value (Values.bindings t.values) in
    Betting.lower values ~runs:t.runs ~miss:(Rat.mul Rat.half miss)
  in
  match Range.both range with
  | Some (low, high) when Rat.equal low high -> (Some low, Some low)
  | Some (low, high) when range.ends_only ->
    let low, high = of_share t ~low ~high ~miss:look in
    (Some low, Some high)
  | Some _ | None ->
    ( Option.map (fun low -> Rat.add low (bound (fun x -> Rat.sub x low))) range.low,
      Option.map (fun high -> Rat.sub high (bound (fun x -> Rat.sub high x))) range.high )

let known_mean t =
  if t.numbers = 0 || open_ended t = 0 then None else Some (Rat.div t.sum (Rat.of_int t.numbers))

let spread t =
  if t.numbers = 0 then None
  else
    let mean = Rat.div t.sum (Rat.of_int t.numbers) in
    let around = Rat.sub t.squares (Rat.mul t.sum mean) in
    let deviation =
      if t.numbers = 1 then None else Some (Rat.root (Rat.div around (Rat.of_int (t.numbers - 1))))
    in
    Some (mean, deviation)
