(* The laws of CTL that rule CtlLaws lists, at random on timed graphs, at every node and inside every flow; and
   for each of those that it says fail a graph on which they do. *)

open Scc_ctl
open Scc_exact
open Scc_test_ctl
open Timed_formula
open Letters
module Gen = QCheck2.Gen

type case = {
  graph : Small.t;
  f : Timed_formula.t;
  g : Timed_formula.t;
  h : Timed_formula.t;
  a : Rat.t;
  b : Rat.t;
}

let print c =
  Printf.sprintf "%s\nf = %s\ng = %s\nh = %s\na = %s, b = %s" (Small.print c.graph) (Small.print_formula c.f)
    (Small.print_formula c.g) (Small.print_formula c.h) (Rat.to_string c.a) (Rat.to_string c.b)

let gen =
  let open Gen in
  let* graph = Small.gen ~unsure:false ~truncated:false in
  let sub = int_range 0 1 >>= Small.formula_gen graph.unit in
  let time = map (fun k -> Rat.mul graph.unit (Rat.of_int k)) (int_range 0 3) in
  let* f = sub and* g = sub and* h = sub in
  let* a = time and* b = time in
  return { graph; f; g; h; a; b }

let everywhere (graph : Small.t) =
  let inside s =
    List.init (Small.cells graph.nodes.(s)) (fun i -> { Positions.node = s; offset = Small.offset graph i })
  in
  List.concat_map (fun s -> Positions.start s :: inside s) (List.init (Array.length graph.nodes) Fun.id)

let valid graph formula =
  let e = Small.evaluator graph in
  List.for_all (fun p -> Eval.truth e formula p = Some true) (everywhere graph)

let implies f g = Or [ Not f; g ]
let iff f g = And [ implies f g; implies g f ]
let within high = { low = Rat.zero; high = Some high }
let true_ = And []

let laws =
  [
    ("AG f = not EF not f", fun c -> iff (ag c.f) (Not (ef (Not c.f))));
    ("AF f = not EG not f", fun c -> iff (af c.f) (Not (eg (Not c.f))));
    ("AX f = not EX not f", fun c -> iff (ax c.f) (Not (ex (Not c.f))));
    ("EG true", fun _ -> eg true_);
    ("AX f and EX true => EX f", fun c -> implies (And [ ax c.f; ex true_ ]) (ex c.f));
    ("f => AF f", fun c -> implies c.f (af c.f));
    ("AG f => EG f => f", fun c -> And [ implies (ag c.f) (eg c.f); implies (eg c.f) c.f ]);
    ("AF f => EF f", fun c -> implies (af c.f) (ef c.f));
    ("EF EF f = EF f", fun c -> iff (ef (ef c.f)) (ef c.f));
    ("AG AG f = AG f", fun c -> iff (ag (ag c.f)) (ag c.f));
    ("AF AF f = AF f", fun c -> iff (af (af c.f)) (af c.f));
    ("EG EG f = EG f", fun c -> iff (eg (eg c.f)) (eg c.f));
    ("E[f U E[f U g]] = E[f U g]", fun c -> iff (eu c.f (eu c.f c.g)) (eu c.f c.g));
    ("A[f U A[f U g]] = A[f U g]", fun c -> iff (au c.f (au c.f c.g)) (au c.f c.g));
    ("g => A[f U g] => E[f U g] => EF g",
     fun c ->
       And
         [ implies c.g (au c.f c.g); implies (au c.f c.g) (eu c.f c.g); implies (eu c.f c.g) (ef c.g);
           implies (au c.f c.g) (af c.g) ]);
    ("E[f U g] => f or g", fun c -> implies (Or [ eu c.f c.g; au c.f c.g ]) (Or [ c.f; c.g ]));
    ("EX (f or g) = EX f or EX g", fun c -> iff (ex (Or [ c.f; c.g ])) (Or [ ex c.f; ex c.g ]));
    ("AX (f and g) = AX f and AX g", fun c -> iff (ax (And [ c.f; c.g ])) (And [ ax c.f; ax c.g ]));
    ("EF (f or g) = EF f or EF g", fun c -> iff (ef (Or [ c.f; c.g ])) (Or [ ef c.f; ef c.g ]));
    ("AG (f and g) = AG f and AG g", fun c -> iff (ag (And [ c.f; c.g ])) (And [ ag c.f; ag c.g ]));
    ("E[f U (g or h)] = E[f U g] or E[f U h]",
     fun c -> iff (eu c.f (Or [ c.g; c.h ])) (Or [ eu c.f c.g; eu c.f c.h ]));
    ("A[(f and g) U h] = A[f U h] and A[g U h]",
     fun c -> iff (au (And [ c.f; c.g ]) c.h) (And [ au c.f c.h; au c.g c.h ]));
    ("U is monotone",
     fun c ->
       And
         [ implies (eu c.f c.g) (eu (Or [ c.f; c.h ]) (Or [ c.g; c.h ]));
           implies (au c.f c.g) (au (Or [ c.f; c.h ]) (Or [ c.g; c.h ])) ]);
    ("AG (f => g) => (AG f => AG g)", fun c -> implies (ag (implies c.f c.g)) (implies (ag c.f) (ag c.g)));
    ("AG (f => g) => (EG f => EG g)", fun c -> implies (ag (implies c.f c.g)) (implies (eg c.f) (eg c.g)));
    ("AG f and EF g => EF (f and g)", fun c -> implies (And [ ag c.f; ef c.g ]) (ef (And [ c.f; c.g ])));
    ("AG f and A[g U h] => A[(f and g) U h]",
     fun c -> implies (And [ ag c.f; au c.g c.h ]) (au (And [ c.f; c.g ]) c.h));
    ("AG f = f and AX AG f, one way", fun c -> implies (ag c.f) (And [ c.f; ax (ag c.f) ]));
    ("EF f = f or EX EF f, one way", fun c -> implies (Or [ c.f; ex (ef c.f) ]) (ef c.f));
    ("A[f U g] = not (E[not g U (not f and not g)] or EG not g), one way",
     fun c ->
       implies (au c.f c.g) (Not (Or [ eu (Not c.g) (And [ Not c.f; Not c.g ]); eg (Not c.g) ])));
    ("A[f U g] = A[f or g U g] where f or g holds throughout, one way",
     fun c -> implies (And [ ag (Or [ c.f; c.g ]); af c.g ]) (au (Or [ c.f; c.g ]) c.g));
    ("EF[0,a] EF[0,b] f = EF[0,a+b] f",
     fun c -> iff (ef ~b:(within c.a) (ef ~b:(within c.b) c.f)) (ef ~b:(within (Rat.add c.a c.b)) c.f));
    ("AG[0,a] AG[0,b] f = AG[0,a+b] f",
     fun c -> iff (ag ~b:(within c.a) (ag ~b:(within c.b) c.f)) (ag ~b:(within (Rat.add c.a c.b)) c.f));
    ("AF[0,a] AF[0,b] f = AF[0,a+b] f",
     fun c -> iff (af ~b:(within c.a) (af ~b:(within c.b) c.f)) (af ~b:(within (Rat.add c.a c.b)) c.f));
    ("EG[0,a] EG[0,b] f = EG[0,a+b] f",
     fun c -> iff (eg ~b:(within c.a) (eg ~b:(within c.b) c.f)) (eg ~b:(within (Rat.add c.a c.b)) c.f));
    ("A[f U[0,a] A[f U[0,b] g]] = A[f U[0,a+b] g]",
     fun c ->
       iff (au ~b:(within c.a) c.f (au ~b:(within c.b) c.f c.g)) (au ~b:(within (Rat.add c.a c.b)) c.f c.g));
    ("E[f U[0,a] E[f U[0,b] g]] = E[f U[0,a+b] g]",
     fun c ->
       iff (eu ~b:(within c.a) c.f (eu ~b:(within c.b) c.f c.g)) (eu ~b:(within (Rat.add c.a c.b)) c.f c.g));
    ("a greater bound is met as well",
     fun c ->
       let less = within c.a and more = within (Rat.add c.a c.b) in
       And
         [ implies (eu ~b:less c.f c.g) (eu ~b:more c.f c.g); implies (au ~b:less c.f c.g) (au ~b:more c.f c.g);
           implies (au ~b:more c.f c.g) (au c.f c.g) ]);
  ]

let hold =
  let gen = Gen.pair (Gen.oneofl laws) gen in
  let print ((name, _), c) = name ^ "\n" ^ print c in
  QCheck2.Test.make ~count:(100 * List.length laws) ~name:"CtlLaws: those that hold" ~print gen
    (fun ((_, formula), c) -> valid c.graph (formula c))

(* {1 Fewer runs} *)

(* With all quantifiers over all runs, when negations are driven inward. *)
let rec universal q (f : Timed_formula.t) : Timed_formula.t =
  match f with
  | Predicate _ -> f
  | Not f -> Not (universal (Timed_formula.dual q) f)
  | And fs -> And (List.map (universal q) fs)
  | Or fs -> Or (List.map (universal q) fs)
  | Next (_, f) -> Next (q, universal q f)
  | Finally (_, b, f) -> Finally (q, b, universal q f)
  | Globally (_, b, f) -> Globally (q, b, universal q f)
  | Until (_, b, f, g) -> Until (q, b, universal q f, universal q g)

(* Without one of the ways from a node that has another one, so that no new run comes of it. *)
let fewer_gen (graph : Small.t) =
  let ways (node : Small.node) =
    let without_edge i = { node with edges = List.filteri (fun k _ -> k <> i) node.edges } in
    let edges = List.mapi (fun i _ -> without_edge i) node.edges in
    match node.flow with
    | Lasts (d, [ t; u ]) -> List.map (fun t -> { node with flow = Lasts (d, [ t ]) }) [ t; u ] @ edges
    | Lasts _ | Ray _ -> { node with flow = No_flow; cells = Array.map (fun _ -> [||]) node.cells } :: edges
    | No_flow -> edges
  in
  let fewer node = match ways node with [] | [ _ ] -> [ node ] | several -> node :: several in
  Gen.map
    (fun nodes -> { graph with nodes })
    (Gen.flatten_a (Array.map (fun node -> Gen.oneofl (fewer node)) graph.nodes))

let fewer_runs =
  let gen =
    let open Gen in
    let* graph = Small.gen ~unsure:false ~truncated:false in
    let* fewer = fewer_gen graph in
    let* f = int_range 1 3 >>= Small.formula_gen graph.unit in
    return (graph, fewer, universal All f)
  in
  let print (graph, fewer, f) =
    String.concat "\n" [ Small.print graph; Small.print fewer; Small.print_formula f ]
  in
  QCheck2.Test.make ~count:2000 ~name:"CtlLaws: fewer runs break no quantifier over all" ~print gen
    (fun (graph, fewer, f) ->
       let more = Small.evaluator graph and less = Small.evaluator fewer in
       let nodes = List.init (Array.length graph.nodes) Positions.start in
       let holds e formula p = Eval.truth e formula p = Some true in
       List.for_all
         (fun p ->
            ((not (holds more f p)) || holds less f p)
            && (holds more (Not f) p || not (holds less (Not f) p)))
         nodes)

(* {1 Laws that fail} *)

(* Time passes from 0 to the dead end 1: p holds at the start alone, and q on the open interval after it. *)
let into_an_interval = graph [ node "T." ~flow:(Lasts (1, [ 1 ])) ~p:"." ~q:"T"; node ".T" ]

(* p holds in the middle of the flow alone; there is no edge. *)
let on_the_way = graph [ node ".T" ~flow:(Lasts (2, [ 1 ])) ~p:".T." ~q:"T.T"; node ".T" ]

(* 0 chooses between 1, which ends with p alone, and 2, which ends with q alone. *)
let choice = graph [ node ".." ~edges:[ 1; 2 ]; node "T."; node ".T" ]

(* 0 holds p and q, and leads to a choice of 2, with p alone, and 3, with q alone. *)
let parting = graph [ node "TT" ~edges:[ 1; 2 ]; node "T."; node ".T" ]

let at_start g formula = Eval.truth (Small.evaluator g) formula (Positions.start 0)

let fails name g left right expected =
  Alcotest.(check (pair (option bool) (option bool)))
    name
    (Some (fst expected), Some (snd expected))
    (at_start g left, at_start g right)

let fail () =
  let f = fails in
  f "A[f U g] = not (E[not g U (not f and not g)] or EG not g)" into_an_interval (au p q)
    (Not (Or [ eu (Not q) (And [ Not p; Not q ]); eg (Not q) ]))
    (false, true);
  f "EF f = f or EX EF f" on_the_way (ef p) (Or [ p; ex (ef p) ]) (true, false);
  f "AG f = f and AX AG f" on_the_way (ag q) (And [ q; ax (ag q) ]) (false, true);
  f "E[f U g] = g or (f and EX E[f U g])" on_the_way (eu q p) (Or [ p; And [ q; ex (eu q p) ] ]) (true, false);
  f "A[f U g] = g or (f and AX A[f U g])" on_the_way (au true_ (Or [])) (And [ true_; ax (au true_ (Or [])) ])
    (false, true);
  f "EG f = f and EX EG f" on_the_way (eg true_) (And [ true_; ex (eg true_) ]) (true, false);
  f "f and AG (f => AX f) => AG f" on_the_way (And [ q; ag (implies q (ax q)) ]) (ag q) (true, false);
  f "AX f => EX f" on_the_way (ax p) (ex p) (true, false);
  f "AF (f or g) = AF f or AF g" choice (af (Or [ p; q ])) (Or [ af p; af q ]) (true, false);
  f "EF (f and g) = EF f and EF g" choice (ef (And [ p; q ])) (And [ ef p; ef q ]) (false, true);
  f "EG (f and g) = EG f and EG g" parting (eg (And [ p; q ])) (And [ eg p; eg q ]) (false, true);
  f "AG (f or g) = AG f or AG g" parting (ag (Or [ p; q ])) (Or [ ag p; ag q ]) (true, false)

let suite =
  ("laws",
   [
     ("hold", Scc_test_support.Property.cases [ hold; fewer_runs ]);
     ("fail", [ Alcotest.test_case "CtlLaws: those that fail" `Quick fail ]);
   ])
