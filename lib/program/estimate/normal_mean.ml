open Scc_exact

(* {1 The tail of the normal distribution}

   In units of 10^-100, each operation rounded down. 1/2 less the tail is the series of
   (-1)^n z^(2n + 1) / (2^n n! (2n + 1)), times 1/sqrt(2 pi). Its terms are at most e^(z^2/2) < 10^22 for z <= 10,
   so that a hundred digits are plenty. *)

let one = Z.pow (Z.of_int 10) 100

(* 1/sqrt(2 pi) *)
let density =
  Z.of_string
    "3989422804014326779399460599343818684758586311649346576659258296706579258993018385012523339073069364"

let mul a b = Z.div (Z.mul a b) one
let greatest = 10

(* For 0 <= z <= 10, in these units. *)
let tail z =
  let square = mul z z in
  let rec sum n power total =
    let term = Z.div power (Z.of_int ((2 * n) + 1)) in
    if Z.equal term Z.zero then total
    else
      let next = Z.div (mul power square) (Z.of_int (2 * (n + 1))) in
      sum (n + 1) next (if n land 1 = 0 then Z.add total term else Z.sub total term)
  in
  Z.sub (Z.div one (Z.of_int 2)) (mul density (sum 0 z Z.zero))

let places = 1_000_000_000
let at k = Z.div (Z.mul one (Z.of_int k)) (Z.of_int places)

let least_miss = Rat.make Z.one (Z.pow (Z.of_int 10) 20)

let quantile miss =
  let one_side = Rat.mul Rat.half miss in
  let limit = Z.div (Z.mul one one_side.num) one_side.den in
  let rec between low high =
    if high - low <= 1 then high
    else
      let middle = (low + high) / 2 in
      if Z.leq (tail (at middle)) limit then between low middle else between middle high
  in
  Rat.make (Z.of_int (between 0 (greatest * places))) (Z.of_int places)

(* {1 Intervals} *)

let needed = 30

let others tally =
  let most = Tally.Values.fold (fun _ n most -> Int.max n most) tally.Tally.values 0 in
  tally.numbers - most

let interval tally ~miss =
  match Tally.spread tally with
  | Some (mean, Some deviation) when others tally >= needed && Rat.compare miss least_miss >= 0 ->
    let error = Rat.div deviation (Rat.root (Rat.of_int tally.numbers)) in
    Some (mean, Rat.mul (quantile miss) error)
  | Some _ | None -> None
