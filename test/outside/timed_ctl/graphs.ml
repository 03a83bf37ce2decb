(* graphs.exe COUNT SEED: so many random timed graphs, a line of JSON each, with what scc answers (README.md). *)

open Scc_ctl
open Scc_exact
open Scc_test_ctl
module Gen = QCheck2.Gen

(* {1 Random ones} *)

(* The same graph, with the pieces of its trajectories longer: each interval of the time 1 takes a whole number. *)
let stretched (node : Small.node) lengths =
  let total k = List.fold_left ( + ) 0 (List.filteri (fun i _ -> i < k) lengths) in
  let pieces row i v =
    let times = if i land 1 = 1 then 1 else (2 * List.nth lengths (i / 2)) - 1 in
    if i = Array.length row - 1 && (match node.flow with Ray _ -> true | _ -> false) then [ v ]
    else List.init times (fun _ -> v)
  in
  let longer row = Array.of_list (List.concat (List.mapi (pieces row) (Array.to_list row))) in
  let flow : Small.flow =
    match node.flow with
    | No_flow -> No_flow
    | Lasts (d, targets) -> Lasts (total d, targets)
    | Ray k -> Ray (total k)
  in
  { node with flow; cells = Array.map longer node.cells }

let graph_gen ~unsure ~truncated =
  let open Gen in
  let* graph = Small.gen ~unsure ~truncated in
  let stretch node = map (stretched node) (list_repeat 4 (frequencyl [ (3, 1); (1, 2); (1, 3) ])) in
  let* nodes = flatten_a (Array.map stretch graph.nodes) in
  return { Small.nodes; unit = Rat.one }

type value = { start : int; slope : int }

type mean =
  | Time of Timed_formula.t
  | Events of Timed_formula.t
  | Value of value option array * Rat.t  (** by node; none has a value *)

type line = {
  graph : Small.t;
  events : Small.truth list list array;
  (** of the transitions of each node, of all that happens by each, whether it is counted *)
  formulas : Timed_formula.t list;
  chances : (Timed_formula.side * Timed_formula.t) list;
  means : (Timed_formula.side * mean) list;
}

(* Of a formula that is an operator of time. *)
let rec lasting_gen step =
  let open Gen in
  let* (f : Timed_formula.t) = Small.formula_gen step 2 in
  match f with
  | Until _ | Finally _ | Globally _ -> return f
  | Predicate _ | Not _ | And _ | Or _ | Next _ -> lasting_gen step

let mean_gen nodes =
  let open Gen in
  let formula = Small.formula_gen Rat.one in
  let value = map2 (fun start slope -> { start; slope }) (int_range (-5) 9) (int_range (-2) 3) in
  oneof
    [
      map (fun g -> Time g) (formula 1);
      map (fun g -> Events g) (formula 1);
      map2
        (fun values halves -> Value (values, Rat.make (Z.of_int halves) (Z.of_int 2)))
        (array_repeat nodes (frequency [ (12, map Option.some value); (1, return None) ]))
        (int_range 0 12);
    ]

(* Mostly one thing happens by a transition. *)
let events_gen ~unsure (x : Small.node) =
  let open Gen in
  let truth = frequencyl [ (2, Small.T); (1, F); ((if unsure then 1 else 0), U) ] in
  list_repeat (List.length x.edges) (list_size (frequencyl [ (4, 1); (2, 2); (1, 3) ]) truth)

let line_gen =
  let open Gen in
  let kinds = [ (3, (false, false)); (1, (true, false)); (1, (false, true)); (1, (true, true)) ] in
  let* unsure, truncated = frequencyl kinds in
  let* graph = graph_gen ~unsure ~truncated in
  let* events = flatten_a (Array.map (events_gen ~unsure) graph.nodes) in
  let* step = map Rat.of_int (frequencyl [ (3, 1); (1, 2); (1, 3) ]) in
  let* shallow = list_repeat 4 (Small.formula_gen step 1) and* deep = list_repeat 2 (Small.formula_gen step 3) in
  let side = oneofl [ Timed_formula.Least; Greatest ] in
  let* chances = list_repeat 3 (pair side (lasting_gen step)) in
  let* means = list_repeat 3 (pair side (mean_gen (Array.length graph.nodes))) in
  return { graph; events; formulas = shallow @ deep; chances; means }

(* {1 As JSON} *)

let letter : Small.truth -> string = function F -> "." | T -> "T" | U -> "?"
let rat r : Yojson.Basic.t = `String (Rat.to_string r)
let numbers l : Yojson.Basic.t = `List (List.map (fun i -> `Int i) l)

let by_predicate f : Yojson.Basic.t =
  `Assoc (List.init Small.count (fun p -> (String.make 1 (Char.chr (Char.code 'p' + p)), `String (f p))))

let node events (x : Small.node) : Yojson.Basic.t =
  let letters truths = String.concat "" (List.map letter truths) in
  let along p = letters (Array.to_list x.cells.(p)) in
  let trajectory : Yojson.Basic.t =
    match x.flow with
    | No_flow -> `Null
    | Lasts (d, targets) -> `Assoc [ ("time", `Int d); ("to", numbers targets); ("truth", by_predicate along) ]
    | Ray _ -> `Assoc [ ("time", `Null); ("to", `List []); ("truth", by_predicate along) ]
  in
  let drawn = x.drawn && x.edges <> [] in
  let chances = if drawn then Small.chances x else [] in
  let edge i (t, happens) : Yojson.Basic.t =
    let told = List.map (fun chance -> ("probability", rat chance)) (Option.to_list (List.nth_opt chances i)) in
    `Assoc (("to", `Int t) :: ("events", `String (letters happens)) :: told)
  in
  let truth = ("truth", by_predicate (fun p -> letter x.at.(p))) in
  if not x.known then `Assoc [ ("known", `Bool false); truth ]
  else
    `Assoc
      [
        ("known", `Bool true);
        truth;
        ("transitions", `List (List.mapi edge (List.combine x.edges events)));
        ("trajectory", trajectory);
      ]

let side letter : Timed_formula.side -> string = function Least -> letter ^ "min" | Greatest -> letter ^ "max"

let quantifier : Timed_formula.quantifier -> Yojson.Basic.t = function
  | All -> `String "A"
  | Exists -> `String "E"
  | Chance { side = s; test = { relation; than } } ->
    let relation =
      match relation with Less -> "<" | At_most -> "<=" | At_least_so -> ">=" | More -> ">"
    in
    `List [ `String (side "P" s); `String relation; rat than ]

let whole r : Yojson.Basic.t =
  if Rat.is_integer r then `Int (Z.to_int (Rat.floor r)) else failwith "a bound that is no whole number"

let bound (b : Timed_formula.bound) : Yojson.Basic.t =
  `List [ whole b.low; (match b.high with None -> `Null | Some h -> whole h) ]

let rec formula (f : Timed_formula.t) : Yojson.Basic.t =
  let list name l : Yojson.Basic.t = `List (`String name :: l) in
  match f with
  | Predicate p -> `String (String.make 1 (Char.chr (Char.code 'p' + p)))
  | Not f -> list "not" [ formula f ]
  | And l -> list "and" (List.map formula l)
  | Or l -> list "or" (List.map formula l)
  | Next (q, f) -> list "X" [ quantifier q; formula f ]
  | Finally (q, b, f) -> list "F" [ quantifier q; bound b; formula f ]
  | Globally (q, b, f) -> list "G" [ quantifier q; bound b; formula f ]
  | Until (q, b, f, g) -> list "U" [ quantifier q; bound b; formula f; formula g ]

(* {1 Answers} *)

let told = function Some true -> "T" | Some false -> "." | None -> "?"

let judged g e f : Yojson.Basic.t =
  ignore (Eval.value e f);
  let at s = told (Eval.truth e f (Positions.start s)) in
  let along s (x : Small.node) : Yojson.Basic.t =
    let cell i = told (Eval.truth e f { node = s; offset = Small.offset g i }) in
    if x.known && x.flow <> No_flow then `String (String.concat "" (List.init (Small.cells x) cell)) else `Null
  in
  `Assoc
    [
      ("formula", formula f);
      ("truth", `String (String.concat "" (List.init (Array.length g.nodes) at)));
      ("along", `List (Array.to_list (Array.mapi along g.nodes)));
    ]

let answer : Scc_chance.Answer.t -> Yojson.Basic.t = function
  | Exact r -> rat r
  | Infinite -> `String "infinite"
  | Within _ | At_least _ -> failwith "no exact answer on a small graph"

let measured ({ least; most } : Eval.measured) = [ ("least", answer least); ("most", answer most) ]

let chance e (s, f) : Yojson.Basic.t =
  let f' : Yojson.Basic.t =
    match formula f with `List (op :: _ :: rest) -> `List (op :: rest) | other -> other
  in
  let found = Eval.probability e ~decide:false s f (Positions.start 0) in
  `Assoc ([ ("which", `String (side "P" s)); ("of", f') ] @ measured found)

let counted events s k =
  let happens = List.nth events.(s) k in
  let count letters = List.length (List.filter (fun v -> List.mem v letters) happens) in
  (count [ Small.T ], count [ Small.T; U ])

let mean events e (s, mean) : Yojson.Basic.t =
  let what, question =
    match mean with
    | Time g -> (Expectation.Time_until g, [ ("time until", formula g) ])
    | Events g -> (Counts_until (counted events, g), [ ("events until", formula g) ])
    | Value (values, time) ->
      let number s offset =
        match values.(s) with
        | None -> Error "no value"
        | Some { start; slope } -> Ok (Rat.add (Rat.of_int start) (Rat.mul (Rat.of_int slope) offset))
      in
      let told = function None -> `Null | Some { start; slope } -> numbers [ start; slope ] in
      (Value_at (number, time), [ ("values", `List (List.map told (Array.to_list values))); ("at", rat time) ])
  in
  let result =
    match Expectation.find e s what with
    | Known m -> measured m
    | Unknown _ -> [ ("least", `Null); ("most", `Null) ]
  in
  `Assoc ((("which", `String (side "E" s)) :: question) @ result)

let line { graph; events; formulas; chances; means } : Yojson.Basic.t =
  let e = Small.evaluator graph in
  `Assoc
    [
      ("states", `List (List.map2 node (Array.to_list events) (Array.to_list graph.nodes)));
      ("formulas", `List (List.map (judged graph e) formulas));
      ("probabilities", `List (List.map (chance e) chances));
      ("means", `List (List.map (mean events e) means));
    ]

let () =
  match Sys.argv with
  | [| _; count; seed |] ->
    let rand = Random.State.make [| int_of_string seed |] in
    for _ = 1 to int_of_string count do
      print_endline (Yojson.Basic.to_string (line (Gen.generate1 ~rand line_gen)))
    done
  | _ ->
    prerr_endline "usage: graphs.exe COUNT SEED";
    exit 64
