open Scc_exact

type t = Exact of Rat.t | Within of Rat.t * Rat.t | At_least of Rat.t | Infinite
type relation = Less | At_most | At_least_so | More
type bound = { relation : relation; than : Rat.t }

let add a y =
  match a with
  | Exact x -> Exact (Rat.add x y)
  | Within (x, z) -> Within (Rat.add x y, Rat.add z y)
  | At_least x -> At_least (Rat.add x y)
  | Infinite -> Infinite

let compare_bound a b =
  compare a.relation b.relation <?> fun () -> Rat.compare a.than b.than

let sign = function Less -> "<" | At_most -> "<=" | At_least_so -> ">=" | More -> ">"
let bound_to_string b = Printf.sprintf "%s %s" (sign b.relation) (Rat.to_string b.than)

let complement = function
  | Exact x -> Exact (Rat.sub Rat.one x)
  | Within (x, y) -> Within (Rat.sub Rat.one y, Rat.sub Rat.one x)
  | At_least _ | Infinite -> Scc_base.Bug.fail __POS__ "a probability above 1"

let lower = function Exact x | Within (x, _) | At_least x -> Some x | Infinite -> None
let upper = function Exact x | Within (_, x) -> Some x | At_least _ | Infinite -> None

let holds a { relation; than } =
  let low order = match lower a with None -> true | Some x -> order (Rat.compare x than) in
  let high order = match upper a with None -> false | Some x -> order (Rat.compare x than) in
  let decide yes no = if yes then Some true else if no then Some false else None in
  match relation with
  | Less -> decide (high (fun c -> c < 0)) (low (fun c -> c >= 0))
  | At_most -> decide (high (fun c -> c <= 0)) (low (fun c -> c > 0))
  | At_least_so -> decide (low (fun c -> c >= 0)) (high (fun c -> c < 0))
  | More -> decide (low (fun c -> c > 0)) (high (fun c -> c <= 0))

let contains a x =
  match a with
  | Exact y -> Rat.equal x y
  | Within (y, z) -> Rat.compare y x <= 0 && Rat.compare x z <= 0
  | At_least y -> Rat.compare y x <= 0
  | Infinite -> false

let to_string = function
  | Exact x -> Rat.to_string x
  | Within (x, y) -> Printf.sprintf "in [%s, %s]" (Rat.to_string x) (Rat.to_string y)
  | At_least x -> "at least " ^ Rat.to_string x
  | Infinite -> "infinite"
