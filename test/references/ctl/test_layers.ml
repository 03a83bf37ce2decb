(* Probabilities within a bound of time, layer by layer, against one system of equations for all places and times.
   The graphs are small and random; most have no ways back in no time. *)

open Scc_ctl
open Scc_exact
open Scc_chance
open Scc_test_ctl
module Gen = QCheck2.Gen

type case = {
  graph : Small.t;
  f : Timed_formula.t;
  g : Timed_formula.t;
  side : Timed_formula.side;
  bound : Timed_formula.bound;
  generous : bool;
}

let print c =
  Printf.sprintf "%s\n%s U %s, %s, in [%s, %s]" (Small.print c.graph) (Small.print_formula c.f)
    (Small.print_formula c.g)
    (match c.side with Least -> "least" | Greatest -> "greatest")
    (Rat.to_string c.bound.low)
    (Option.fold ~none:"..." ~some:Rat.to_string c.bound.high)

(* Edges lead to later nodes only: no run comes back in no time. *)
let onwards (g : Small.t) =
  let node s (x : Small.node) = { x with edges = List.filter (fun t -> t > s) x.edges } in
  { g with nodes = Array.mapi node g.nodes }

let gen ~truncated =
  let open Gen in
  let* graph = Small.gen ~unsure:false ~truncated in
  let* forwards = frequencyl [ (3, true); (1, false) ] in
  let graph = if forwards then onwards graph else graph in
  let leaf = map (fun p -> Timed_formula.Predicate p) (int_range 0 (Small.count - 1)) in
  let* f = oneof [ return (Timed_formula.And []); leaf ] in
  let* g = leaf in
  let* side = oneofl [ Timed_formula.Least; Greatest ] in
  let* low = frequency [ (3, return 0); (1, int_range 0 6) ] in
  let* more = frequency [ (1, return 0); (5, int_range 0 12); (1, int_range 30 60) ] in
  (* Thirds are at no instant of an event, and other numbers are. *)
  let* parts = oneofl [ 1; 1; 2; 3 ] in
  let time k = Rat.mul graph.unit (Rat.make (Z.of_int k) (Z.of_int parts)) in
  let* generous = bool in
  return { graph; f; g; side; bound = { low = time low; high = Some (time (low + more)) }; generous }

let question c : Likelihood.question =
  let e = Small.evaluator c.graph in
  let set f = (Eval.value e f).lower in
  { graph = Eval.graph e; side = c.side; bound = c.bound; f = set c.f; g = set c.g; generous = c.generous }

let starts (q : Likelihood.question) =
  let w = Decisions.window q in
  (w, List.init q.graph.size (fun s -> Decisions.next q w (Decisions.place w s Rat.zero)))

let whole q w starts =
  let built = Decisions.build ~choices:(Decisions.choices q w) starts in
  let solution =
    Reach.solve (Decisions.until built) (Decisions.direction q.side) Effort.default ~asked:(States built.asked)
  in
  fun next -> Solution.value solution (Decisions.number built next)

let exactly = function Answer.Exact x -> x | a -> failwith ("not exact: " ^ Answer.to_string a)
let same a b = Rat.equal (exactly a) (exactly b)

(* How many of the cases were worked through layer by layer. *)
let by_layers = ref 0

let agrees c =
  let q = question c in
  let w, starts = starts q in
  let expected = whole q w starts in
  match Layers.until q w starts with
  | None -> true
  | Some layers ->
    incr by_layers;
    let exact = Layered.solve layers Effort.default in
    let near = Layered.solve layers { Effort.default with engine = Nearly } in
    let fractions = Layered.solve layers { Effort.default with bits = 8 } in
    let good next =
      let x = expected next in
      same (Layered.value exact next) x
      && Answer.contains (Layered.value near next) (exactly x)
      && Answer.contains (Layered.value fractions next) (exactly x)
    in
    List.for_all good starts

(* Of bounds with more instants than are worked through, the later ones are enclosed. *)
let enclosed_cases = ref 0

let encloses c =
  let q = question c in
  let w, starts = starts q in
  let expected = whole q w starts in
  let contains layers =
    let found = Likelihood.within q { Effort.default with layers } w starts in
    let good next =
      let answer = found next in
      (match answer with
       | Answer.Within _ -> incr enclosed_cases
       | Exact _ | At_least _ | Infinite -> ());
      Answer.contains answer (exactly (expected next))
    in
    List.for_all good starts
  in
  contains 1 && contains 2

let enclosed () = Alcotest.(check bool) "many answers are intervals" true (!enclosed_cases > 200)

(* A run comes to the goal by positive chances, in the fewest steps of all where nothing is chosen. *)
let shows c =
  let q = question c in
  let w, starts = starts q in
  let distance next =
    let built = Decisions.build ~choices:(Decisions.choices q w) [ next ] in
    let m = built.mdp in
    let from = List.hd built.asked in
    let far = Array.make (Mdp.states m) (-1) and waiting = Queue.create () and free = ref false in
    far.(from) <- 0;
    Queue.add from waiting;
    while not (Queue.is_empty waiting) do
      let s = Queue.take waiting in
      if Mdp.first_choice m (s + 1) - Mdp.first_choice m s > 1 then free := true;
      for b = Mdp.first_branch m (Mdp.first_choice m s) to Mdp.first_branch m (Mdp.first_choice m (s + 1)) - 1 do
        let t = Mdp.target m b in
        if far.(t) < 0 then begin
          far.(t) <- far.(s) + 1;
          Queue.add t waiting
        end
      done
    done;
    (far.(0), !free)
  in
  match Layers.until q w starts with
  | None -> true
  | Some layers ->
    let values = Layered.solve layers Effort.default in
    let good next =
      let positive = Rat.sign (exactly (Layered.value values next)) > 0 in
      match Layered.run layers Effort.default next with
      | None -> not positive
      | Some trail ->
        let least, free = distance next in
        let n = List.length trail in
        let to_goal = match List.rev trail with [] -> next = Goal | (_, b) :: _ -> b.next = Goal in
        positive && to_goal && n >= least && (free || n = least)
    in
    List.for_all good starts

(* At each time of a fine grid the row that counts there says what the whole system says for this bound. *)
let curve c =
  let q = question c in
  let high = Option.get c.bound.high in
  let moments = Option.get (Curve.moments ~most:max_int q 0) in
  let at = Curve.horizons moments ~high in
  let rows = List.combine (List.map fst at) (Curve.values q Effort.default 0 (List.map snd at)) in
  let counts time ((m : Timeline.moment), _) =
    let side = Algebraic.compare_rat m.offset time in
    side < 0 || (side = 0 && m.attained)
  in
  let step = Rat.mul c.graph.unit (Rat.make Z.one (Z.of_int 6)) in
  let rec good time =
    Rat.compare time high > 0
    ||
    let q = { q with bound = { c.bound with high = Some time } } in
    let w = Decisions.window q in
    let start = Decisions.next q w (Decisions.place w 0 Rat.zero) in
    let row = List.fold_left (fun found row -> if counts time row then Some row else found) None rows in
    same (snd (Option.get row)) (whole q w [ start ] start) && good (Rat.add time step)
  in
  good c.bound.low

let law name ?(count = 1500) ~truncated f =
  Scc_test_support.Property.case (QCheck2.Test.make ~name ~count ~print (gen ~truncated) f)

let many () = Alcotest.(check bool) "most cases have layers" true (!by_layers > 1500)

(* At each whole time a coin ends the run, or not; the predicate holds at its end. *)
let coin ?effort () =
  let half = Rat.make Z.one (Z.of_int 2) in
  let graph : Timed_graph.t =
    {
      size = 3;
      known = (fun _ -> true);
      edges = (fun s -> if s = 0 then [| 1; 2 |] else [||]);
      drawn = (fun s -> if s = 0 then Some [| Some half; Some half |] else None);
      flow = (fun s -> if s = 0 then No_flow else if s = 1 then Lasts (Rat.one, [| 0 |]) else Forever);
    }
  in
  let predicates =
    { Eval.at = (fun _ s -> Truth.of_bool (s = 2)); along = (fun _ _ e -> Timeline.constant e Truth.False);
      steady = (fun _ -> true) }
  in
  Eval.create ?effort (Timed_graph.index graph) predicates

(* The numbers of a long run are longer than allowed, and are enclosed. *)
let long () =
  let e = coin () in
  let found n =
    let f = Timed_formula.Finally (Exists, { low = Rat.zero; high = Some (Rat.of_int n) }, Predicate 0) in
    (Eval.probability e ~decide:false Greatest f (Positions.start 0)).least
  in
  let expected n = Rat.sub Rat.one (Rat.make Z.one (Z.shift_left Z.one (n + 1))) in
  Alcotest.(check bool) "exact" true (same (found 5_000) (Exact (expected 5_000)));
  match found 20_000 with
  | Within (low, high) ->
    Alcotest.(check bool) "contains it" true (Answer.contains (Within (low, high)) (expected 20_000));
    let width = Rat.sub high low in
    Alcotest.(check bool) "narrow" true (Rat.compare width (Rat.make Z.one (Z.shift_left Z.one 100)) < 0)
  | _ -> Alcotest.fail "no interval"

(* Means and curves up to a time with more instants than are worked through end with a reason. *)
let far () =
  let e = coin ~effort:{ Effort.default with layers = 2 } () in
  let value s _ = Ok (Rat.of_int s) in
  let mean n =
    match Expectation.find e Least (Value_at (value, Rat.of_int n)) with
    | Known { least; _ } -> Answer.to_string least
    | Unknown { reason; _ } -> Option.get reason
  and curve n =
    let f = Timed_formula.Finally (Exists, { low = Rat.zero; high = Some (Rat.of_int n) }, Predicate 0) in
    match Option.get (Eval.curve e Greatest f 0) with
    | Ok points -> string_of_int (List.length points)
    | Error reason -> reason
  in
  let reason n =
    Printf.sprintf
      "up to time %d there are more than 32 instants at which something happens, of which time 31 is one; ask for \
       an earlier time"
      n
  in
  let check = Alcotest.(check string) in
  check "a mean" "2047/1024" (mean 9);
  check "a curve" "10" (curve 9);
  check "a mean, far away" (reason 1_000_000_000) (mean 1_000_000_000);
  check "a curve, far away" (reason 1_000_000_000) (curve 1_000_000_000)

let suite =
  ("layers",
   [
     ( "random graphs",
       [
         law "probabilities" ~truncated:false agrees;
         law "probabilities on truncated graphs" ~truncated:true agrees;
         Alcotest.test_case "layers there are" `Quick many;
         law "bounds of many instants" ~truncated:false encloses;
         Alcotest.test_case "enclosed ones there are" `Quick enclosed;
         law "runs" ~truncated:false shows;
         law "curves" ~count:150 ~truncated:false curve;
       ] );
     ( "by hand",
       [ Alcotest.test_case "long numbers" `Quick long; Alcotest.test_case "too many instants" `Quick far ] );
   ])
