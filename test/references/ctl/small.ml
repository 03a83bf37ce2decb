open Scc_ctl
open Scc_exact

type truth = F | T | U
type flow = No_flow | Lasts of int * int list | Ray of int

type node = {
  at : truth array;
  cells : truth array array;
  edges : int list;
  drawn : bool;
  others : int;
  flow : flow;
  known : bool;
}

type t = { nodes : node array; unit : Rat.t }

let time g k = Rat.mul g.unit (Rat.of_int k)
let cells node = match node.flow with No_flow -> 0 | Lasts (d, _) -> (2 * d) - 1 | Ray k -> (2 * k) + 1
let cell a i = a.(Int.min i (Array.length a - 1))

let split node list =
  let n = Int.max 1 (List.length list - node.others) in
  (List.filteri (fun i _ -> i < n) list, List.filteri (fun i _ -> i >= n) list)

let chances node =
  let drawn, _ = split node node.edges in
  let n = List.length drawn in
  List.mapi (fun i _ -> Rat.make (Z.of_int (2 * (i + 1))) (Z.of_int (n * (n + 1)))) drawn

let graph g : Timed_graph.t =
  {
    size = Array.length g.nodes;
    known = (fun s -> g.nodes.(s).known);
    edges = (fun s -> Array.of_list g.nodes.(s).edges);
    drawn =
      (fun s ->
         let node = g.nodes.(s) in
         if not (node.drawn && node.edges <> []) then None
         else
           let _, others = split node node.edges in
           Some (Array.of_list (List.map Option.some (chances node) @ List.map (fun _ -> None) others)));
    flow =
      (fun s ->
         match g.nodes.(s).flow with
         | No_flow -> No_flow
         | Lasts (d, targets) -> Lasts (time g d, Array.of_list targets)
         | Ray _ -> Forever);
  }

let truth = function F -> Truth.False | T -> Truth.True | U -> Truth.Undecided "unsure"

let predicates g : Eval.predicates =
  let at p s = truth g.nodes.(s).at.(p) in
  let is_steady p =
    let same node = Array.for_all (fun v -> v = node.at.(p)) node.cells.(p) in
    Array.for_all same g.nodes
  in
  let along p s extent =
    let node = g.nodes.(s) in
    if is_steady p then failwith "asked along flows of what is steady";
    if not node.known then failwith "the flow of a node that is not known";
    let value r =
      if Rat.sign r = 0 then at p s
      else
        let x = Rat.div r g.unit in
        let k = Z.to_int (Rat.floor x) in
        truth (cell node.cells.(p) (if Rat.is_integer x then (2 * k) - 1 else 2 * k))
    in
    let cuts = List.init (cells node) (fun k -> time g (k + 1)) in
    Timeline.of_cuts extent cuts Truth.equal value
  in
  { at; along; steady = is_steady }

let evaluator ?effort g = Eval.create ?effort (Timed_graph.index (graph g)) (predicates g)

(* Not always the middle: what holds there must hold on the whole interval. *)
let offset g i =
  if i land 1 = 1 then Algebraic.of_rat (time g ((i + 1) / 2))
  else
    let part = if i land 2 = 0 then Rat.make Z.one (Z.of_int 3) else Rat.make (Z.of_int 7) (Z.of_int 8) in
    Algebraic.of_rat (Rat.mul g.unit (Rat.add (Rat.of_int (i / 2)) part))

(** {1 Random ones} *)

module Gen = QCheck2.Gen

let count = 2

let node_gen n ~weights ~known =
  let open Gen in
  let truth = frequency (List.map (fun (w, v) -> (w, return v)) weights) in
  let target = int_range 0 (n - 1) in
  let* edges = list_size (frequencyl [ (3, 0); (4, 1); (2, 2); (1, 3) ]) target in
  let* flow =
    frequency
      [
        (3, return No_flow);
        (4, map2 (fun d t -> Lasts (d, [ t ])) (int_range 1 3) target);
        (1, map2 (fun d l -> Lasts (d, l)) (int_range 1 2) (list_repeat 2 target));
        (1, map (fun k -> Ray k) (int_range 0 2));
      ]
  in
  let* known = known in
  let* by_lot = bool in
  let drawn = by_lot && edges <> [] && flow = No_flow in
  let* others = if drawn then int_range 0 (List.length edges - 1) else return 0 in
  let* at = array_repeat count truth in
  let blank = { at; cells = [||]; edges; drawn; others; flow; known } in
  (* Often the same all the way. *)
  let* varied = bool in
  let along v = if varied then array_repeat (cells blank) truth else return (Array.make (cells blank) v) in
  let* cells = flatten_a (Array.map along at) in
  return { blank with cells }

let weights_gen ~unsure =
  let open Gen in
  let* weights = oneofl [ [ (1, T); (1, F) ]; [ (5, T); (1, F) ]; [ (1, T); (5, F) ] ] in
  return (if unsure then (1, U) :: weights else weights)

let gen ~unsure ~truncated =
  let open Gen in
  let* n = int_range 1 6 in
  let* weights = weights_gen ~unsure in
  let known = if truncated then frequencyl [ (4, true); (1, false) ] else return true in
  let* nodes = array_repeat n (node_gen n ~weights ~known) in
  let* unit = oneofl [ Rat.one; Rat.make (Z.of_int 2) (Z.of_int 3) ] in
  return { nodes; unit }

(* New nodes may come after those that were found. *)
let complete g =
  let open Gen in
  let* more = int_range 0 2 in
  let n = Array.length g.nodes + more in
  let* weights = weights_gen ~unsure:false in
  let fresh = node_gen n ~weights ~known:(return true) in
  let old node =
    if node.known then return node
    else
      let* other = fresh in
      return { other with at = node.at }
  in
  let* old = flatten_a (Array.map old g.nodes) in
  let* added = array_repeat more fresh in
  return { g with nodes = Array.append old added }

let formula_gen unit_of_time depth =
  let time k = Rat.mul unit_of_time (Rat.of_int k) in
  let open Gen in
  let bound : Timed_formula.bound t =
    let* low = frequencyl [ (5, 0); (1, 1); (1, 2); (1, 4) ] in
    let* more = frequencyl [ (5, None); (1, Some 0); (2, Some 1); (2, Some 2); (1, Some 5) ] in
    return
      { Timed_formula.low = time low; high = Option.map (fun m -> time (low + m)) more }
  in
  let quantifier = oneofl [ Timed_formula.All; Exists ] in
  let chance =
    let* side = oneofl [ Timed_formula.Least; Greatest ] in
    let* relation = oneofl [ Scc_chance.Answer.Less; At_most; At_least_so; More ] in
    let* n, d = oneofl [ (0, 1); (1, 6); (1, 3); (1, 2); (2, 3); (1, 1) ] in
    return (Timed_formula.Chance { side; test = { relation; than = Rat.make (Z.of_int n) (Z.of_int d) } })
  in
  let lasting = frequency [ (2, quantifier); (2, chance) ] in
  let leaf = map (fun p -> Timed_formula.Predicate p) (int_range 0 (count - 1)) in
  let rec go depth =
    if depth = 0 then leaf
    else
      let sub = go (depth - 1) in
      frequency
        [
          (1, leaf);
          (1, map (fun f -> Timed_formula.Not f) sub);
          (1, map2 (fun f g -> Timed_formula.And [ f; g ]) sub sub);
          (1, map2 (fun f g -> Timed_formula.Or [ f; g ]) sub sub);
          (2, map2 (fun q f -> Timed_formula.Next (q, f)) quantifier sub);
          (2, map3 (fun q b f -> Timed_formula.Finally (q, b, f)) lasting bound sub);
          (2, map3 (fun q b f -> Timed_formula.Globally (q, b, f)) lasting bound sub);
          ( 4,
            let* q = lasting in
            let* b = bound in
            map2 (fun f g -> Timed_formula.Until (q, b, f, g)) sub sub );
        ]
  in
  go depth

let letter = function F -> "." | T -> "T" | U -> "?"
let row a = String.concat "" (Array.to_list (Array.map letter a))
let rows a = String.concat " " (Array.to_list (Array.map row a))
let numbers l = String.concat "," (List.map string_of_int l)

let print g =
  let node i x =
    let flow =
      match x.flow with
      | No_flow -> ""
      | Lasts (d, l) -> Printf.sprintf " in %d to %s [%s]" d (numbers l) (rows x.cells)
      | Ray _ -> Printf.sprintf " for ever [%s]" (rows x.cells)
    in
    Printf.sprintf "%d%s %s -> %s%s" i (if x.known then "" else " (unknown)") (row x.at)
      (if not x.drawn then numbers x.edges
       else
         let drawn, others = split x x.edges in
         Printf.sprintf "by lot %s or %s" (numbers drawn) (numbers others))
      flow
  in
  String.concat "\n" (Array.to_list (Array.mapi node g.nodes) @ [ "unit " ^ Rat.to_string g.unit ])

let print_formula f = Timed_formula.to_string (fun p -> String.make 1 (Char.chr (Char.code 'p' + p))) f
