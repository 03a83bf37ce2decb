(* Probabilities within a bound of time, with ways back in no time: against all policies that depend on the node
   and the time alone, one by one, each a system of equations of one instant. *)

open Scc_ctl
open Scc_exact
open Scc_test_ctl
module Gen = QCheck2.Gen

type case = { graph : Small.t; side : Timed_formula.side; bound : int }

let print { graph; side; bound } =
  Printf.sprintf "%s\n%s within %d" (Small.print graph)
    (match side with Least -> "least" | Greatest -> "greatest")
    bound

(* The goal is p, in nodes alone: in node 0, and seldom in others. Runs end in node 1. Most nodes draw, some more
   than once in an instant. *)
let node n i : Small.node Gen.t =
  let open Gen in
  let target = int_bound (n - 1) in
  let blank =
    { Small.at = [| F; F |]; cells = [| [||]; [||] |]; edges = []; drawn = false; others = 0; flow = No_flow;
      known = true }
  in
  let lasts = map2 (fun d l -> Small.Lasts (d, l)) (int_range 1 2) (list_size (int_range 1 2) target) in
  let with_cells (x : Small.node) = { x with cells = Array.make 2 (Array.make (Small.cells x) Small.F) } in
  let draws =
    let* edges = list_size (int_range 2 4) target in
    let* others = int_bound (List.length edges - 2) in
    pure { blank with edges; drawn = true; others }
  and passes = map (fun flow -> { blank with flow }) lasts
  and chooses = map2 (fun edges flow -> { blank with edges; flow }) (list_size (int_range 1 2) target)
      (oneof [ lasts; pure Small.No_flow; pure (Small.Ray 0) ])
  in
  let* x = if i = 1 then pure blank else frequency [ (6, draws); (3, passes); (3, chooses) ] in
  let* goal = if i = 0 then pure Small.T else frequencyl [ (12, Small.F); (1, T) ] in
  pure (with_cells { x with at = [| goal; F |] })

let gen =
  let open Gen in
  let* n = int_range 3 6 in
  let* nodes = flatten_a (Array.init n (node n)) in
  let* unit = oneofl [ Rat.one; Rat.make (Z.of_int 2) (Z.of_int 3) ] in
  let* side = oneofl [ Timed_formula.Least; Greatest ] and* bound = int_range 0 4 in
  pure { graph = { nodes; unit }; side; bound }

(* Where an option leads: nodes of this instant with their probabilities, or what comes later, whose value is
   known. *)
type option = Now of (int * Rat.t) list | Later of Rat.t

(* [value t s] is the value of node s at a later time t. *)
let options { graph; bound; _ } value time s =
  let x = graph.nodes.(s) in
  let drawn = x.drawn && x.edges <> [] in
  let lots, others = if drawn then Small.split x x.edges else ([], x.edges) in
  let draws = if drawn then [ Now (List.combine lots (Small.chances x)) ] else [] in
  let single t = Now [ (t, Rat.one) ] in
  let flow =
    match x.flow with
    | No_flow -> []
    | Lasts (d, targets) ->
      List.map (fun t -> Later (if time + d > bound then Rat.zero else value (time + d) t)) targets
    | Ray _ -> [ Later Rat.zero ]
  in
  match draws @ List.map single others @ flow with [] -> [ Later Rat.zero ] | all -> all

(* The least solution of the equations of one policy: Gauss and Jordan where something positive can be reached. *)
let of_policy ~goal policy =
  let n = Array.length policy in
  let at_once s = goal s || match policy.(s) with Later v -> Rat.sign v > 0 | Now _ -> false in
  let positive = Array.init n at_once in
  for _ = 1 to n do
    Array.iteri
      (fun s o -> match o with
         | Now l -> if List.exists (fun (t, _) -> positive.(t)) l then positive.(s) <- true
         | Later _ -> ())
      policy
  done;
  let row s =
    let a = Array.make (n + 1) Rat.zero in
    a.(s) <- Rat.one;
    (if goal s then a.(n) <- Rat.one
     else
       match policy.(s) with
       | Later v -> a.(n) <- v
       | Now l ->
         if positive.(s) then List.iter (fun (t, p) -> if positive.(t) then a.(t) <- Rat.sub a.(t) p) l);
    a
  in
  let m = Array.init n row in
  for k = 0 to n - 1 do
    let pivot = ref k in
    while Rat.sign m.(!pivot).(k) = 0 do incr pivot done;
    let lead = m.(!pivot) in
    m.(!pivot) <- m.(k);
    m.(k) <- Array.map (fun x -> Rat.div x lead.(k)) lead;
    for i = 0 to n - 1 do
      let f = m.(i).(k) in
      if i <> k && Rat.sign f <> 0 then m.(i) <- Array.mapi (fun j x -> Rat.sub x (Rat.mul f m.(k).(j))) m.(i)
    done
  done;
  Array.map (fun row -> row.(n)) m

let rec policies = function
  | [] -> [ [] ]
  | first :: rest ->
    let tails = policies rest in
    List.concat_map (fun o -> List.map (List.cons o) tails) first

let most = 300

(* The values at all instants, the last one first; [None] if there are too many policies. *)
let values c =
  let n = Array.length c.graph.nodes in
  let goal s = c.graph.nodes.(s).at.(0) = Small.T in
  let found = Array.make (c.bound + 1) [||] in
  let better x y =
    let order = Rat.compare x y in
    match c.side with Timed_formula.Least -> order < 0 | Greatest -> order > 0
  in
  let rec go time =
    if time < 0 then Some found.(0)
    else
      let later t s = found.(t).(s) in
      let all = List.init n (fun s -> if goal s then [ Later Rat.one ] else options c later time s) in
      if List.fold_left (fun k o -> k * List.length o) 1 all > most then None
      else begin
        let each = List.map (fun p -> of_policy ~goal (Array.of_list p)) (policies all) in
        let best x y = if better y x then y else x in
        found.(time) <- List.fold_left (Array.map2 best) (List.hd each) (List.tl each);
        go (time - 1)
      end
  in
  go c.bound

let cases = ref 0
let between = ref 0

let agrees c =
  match values c with
  | None -> true
  | Some expected ->
    incr cases;
    if Array.exists (fun x -> Rat.sign x > 0 && Rat.compare x Rat.one < 0) expected then incr between;
    let e = Small.evaluator c.graph in
    let high = Some (Rat.mul c.graph.unit (Rat.of_int c.bound)) in
    let f = Timed_formula.Finally (Exists, { low = Rat.zero; high }, Predicate 0) in
    let good s x =
      let { Eval.least; most } = Eval.probability e ~decide:false c.side f (Positions.start s) in
      let is (a : Scc_chance.Answer.t) =
        match a with Exact y -> Rat.equal x y | Within _ | At_least _ | Infinite -> false
      in
      is least && is most
    in
    List.for_all Fun.id (List.mapi good (Array.to_list expected))

let many () =
  Alcotest.(check bool) (Printf.sprintf "%d cases, %d between 0 and 1" !cases !between) true
    (!cases > 700 && !between > 150)

let suite =
  ("enumeration",
   [
     ( "all policies",
       [
         Scc_test_support.Property.case
           (QCheck2.Test.make ~name:"Probability: within a bound of time" ~count:1_000 ~print gen agrees);
         Alcotest.test_case "most are tried" `Quick many;
       ] );
   ])
