open Property

type t = { numbers : num list; predicates : prop list }

let none = { numbers = []; predicates = [] }

let of_num = function
  | Const _ | Quantity _ -> none
  | Count predicates -> { none with predicates }
  | Neg a -> { none with numbers = [ a ] }
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) -> { none with numbers = [ a; b ] }
  | If (p, a, b) -> { numbers = [ a; b ]; predicates = [ p ] }

let of_prop = function
  | Bool _ | Fact _ -> none
  | Compare (_, a, b) -> { none with numbers = [ a; b ] }
  | Not p -> { none with predicates = [ p ] }
  | And predicates | Or predicates -> { none with predicates }

let of_temporal = function
  | State _ -> []
  | Temporal_not f | Next (_, f) | Finally (_, _, f) | Globally (_, _, f) -> [ f ]
  | Temporal_and fs | Temporal_or fs -> fs
  | Until (_, _, f, g) -> [ f; g ]

let map_num ~num ~prop n =
  match n with
  | Const _ | Quantity _ -> n
  | Count ps -> Count (List.map prop ps)
  | Neg a -> Neg (num a)
  | Add (a, b) -> Add (num a, num b)
  | Sub (a, b) -> Sub (num a, num b)
  | Mul (a, b) -> Mul (num a, num b)
  | Div (a, b) -> Div (num a, num b)
  | If (p, a, b) -> If (prop p, num a, num b)

let map_prop ~num ~prop p =
  match p with
  | Bool _ | Fact _ -> p
  | Compare (c, a, b) -> Compare (c, num a, num b)
  | Not p -> Not (prop p)
  | And ps -> And (List.map prop ps)
  | Or ps -> Or (List.map prop ps)

let map_temporal temporal f =
  match f with
  | State _ -> f
  | Temporal_not f -> Temporal_not (temporal f)
  | Temporal_and fs -> Temporal_and (List.map temporal fs)
  | Temporal_or fs -> Temporal_or (List.map temporal fs)
  | Next (q, f) -> Next (q, temporal f)
  | Finally (q, b, f) -> Finally (q, b, temporal f)
  | Globally (q, b, f) -> Globally (q, b, temporal f)
  | Until (q, b, f, g) -> Until (q, b, temporal f, temporal g)
