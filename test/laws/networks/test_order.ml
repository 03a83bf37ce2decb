(* Nothing depends on the order in which processes are declared, nor on what they are called (reading I-5):
   every model of specs/models, as it is and with rounding, with turns or with laws of motion added, under
   random permutations of its leaves and with other names has the same transitions and the same verdicts. *)

open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_verify
open Scc_test_models
open Scc_test_networks

let standard = Scc_engine.Standard.of_model
let folder = "../../../specs/models"

type network = { model : Model.t; declared : State.t; checks : Property.check list }

let loaded (e : Scc_elaborate.Elaborate.t) = { model = e.model; declared = e.declared; checks = e.checks }
let load name = loaded (Load.exactly (Load.file (Filename.concat folder name)))

let names =
  Sys.readdir folder |> Array.to_list
  |> List.filter (fun name -> Filename.check_suffix name ".sc")
  |> List.sort String.compare

(* {1 Other orders and names} *)

let shuffled rand n =
  let a = Array.init n Fun.id in
  for i = n - 1 downto 1 do
    let j = Random.State.int rand (i + 1) in
    let x = a.(i) in
    a.(i) <- a.(j);
    a.(j) <- x
  done;
  a

(* Names that are in another order than before. *)
let renamed rand (m : Model.t) =
  let numbers = shuffled rand (Array.length m.leaves) in
  let name i (l : Model.leaf) =
    let name = Printf.sprintf "n%d" numbers.(i) in
    let part k (p : Model.part) = { p with name = Printf.sprintf "%s.%d" name k } in
    { l with name; parts = Array.mapi part l.parts }
  in
  { m with leaves = Array.mapi name m.leaves }

let symmetry rand ?perm (m : Model.t) =
  let perm = match perm with Some p -> p | None -> shuffled rand (Array.length m.leaves) in
  let s = Symmetry.permutation perm in
  (perm, { s with model = (fun m -> renamed rand (s.model m)) })

(* {1 What is added} *)

let rounding (m : Model.t) =
  let round r = { r with Model.round_orientation = Some 6 } in
  { m with rigid = Option.map round m.rigid; round_velocity = Some 9 }

let turning (m : Model.t) =
  match m.rigid with
  | Some _ -> m
  | None ->
    let resolution = Scc_exact.Rat.make Z.one (Z.of_int 1024) in
    let dynamics = Model.Free_body in
    {
      m with
      rigid = Some { dynamics; resolution; round_orientation = Some 6 };
      round_velocity = Some 9;
    }

(* A pull towards the origin: what it gives depends on where a body is. *)
let laws (m : Model.t) =
  let half = Law.Const (Scc_exact.Rat.make Z.one (Z.of_int 2)) in
  let pulled v x = Law.Sub (Var v, Mul (half, Mul (Var x, Var Dt))) in
  let law = Law.Gives (Law.velocity_alone (pulled Vx X, pulled Vy Y, pulled Vz Z)) in
  let pull (l : Model.leaf) = if l.fixed then l else { l with law } in
  { m with leaves = Array.map pull m.leaves; steered = true }

let with_step (n : network) =
  let step =
    if n.model.steered then Some { State.remaining = n.model.timestep; phase = State.Due } else None
  in
  { n with declared = State.make ~processes:(Array.to_list n.declared.processes) ~step ~time:n.declared.time }

let variants =
  [
    ("as it is", 60, Fun.id); ("rounded", 40, rounding); ("with turns", 10, turning);
    ("with laws", 12, laws); ("with turns, laws and rounding", 8, fun m -> laws (rounding (turning m)));
  ]

(* {1 Transitions} *)

(* Numbers of bodies that are not rounded grow without end. *)
let longest = 4_000

let bits (s : State.t) =
  let of_vec (v : Scc_exact.Vec.t) = Scc_exact.(Rat.bits v.x + Rat.bits v.y + Rat.bits v.z) in
  let leaf n (l : State.leaf) = n + of_vec l.position + Scc_exact.Quaternion.bits l.turned in
  Array.fold_left
    (fun n (p : State.process) -> Array.fold_left leaf (n + of_vec p.velocity + of_vec p.spin) p.leaves)
    0 s.processes

(* Breadth first, through states of short numbers. *)
let reached (n : network) ~limit =
  let seen = ref [] and queue = Queue.create () and known = Hashtbl.create 64 in
  let add s =
    let same = Hashtbl.find_all known (State.hash s) in
    if not (List.exists (State.equal s) same) then begin
      Hashtbl.add known (State.hash s) s;
      Queue.add s queue
    end
  in
  Result.iter add (Network.initial (standard n.model) n.declared);
  while (not (Queue.is_empty queue)) && List.length !seen < limit do
    let s = Queue.pop queue in
    match Network.successors (standard n.model) s with
    | Ok ts when bits s <= longest ->
      seen := (s, ts) :: !seen;
      List.iter (fun (t : Transition.t) -> add t.target) ts
    | Ok _ | Error _ -> ()
  done;
  !seen

let transitions seed (variant, limit, change) () =
  let rand = Random.State.make [| seed |] in
  List.iter
    (fun name ->
       let n = load name in
       let n = with_step { n with model = change n.model } in
       let _, symmetry = symmetry rand n.model in
       match Symmetry.broken symmetry n.model (reached n ~limit) with
       | None -> ()
       | Some why -> Alcotest.failf "%s, %s: %s" name variant why)
    names

(* {1 Verdicts} *)

let options = { Setup.default with bounds = { Bounds.default with depth = Default 200; states = Default 1_000 } }

let verdicts n =
  match Network.initial (standard n.model) n.declared with
  | Error _ -> []
  | Ok initial ->
    (Check.run options (standard n.model) ~initial n.checks).outcomes
    |> List.map (fun (o : Verdict.outcome) ->
        let kind =
          match o.verdict with
          | Holds _ -> if Verdict.exhaustive o.verdict then "holds" else "bounded"
          | Violated _ -> "violated"
          | Measured { values; _ } -> Scc_explain.Likelihoods.values values
          | Depends _ | Undecided _ -> "undecided"
        in
        o.check.name ^ ": " ^ kind)

let renamed_mean f = function
  | Property.Time_until g -> Property.Time_until (Rename.temporal f g)
  | Events_until (e, g) -> Events_until (Rename.prop f e, Rename.temporal f g)
  | Value_at (n, time) -> Value_at (Rename.num f n, time)

let renamed f (c : Property.check) =
  let asked =
    match c.asked with
    | (Whether | How_likely _) as asked -> asked
    | Expected (sides, m, test) -> Property.Expected (sides, renamed_mean f m, test)
  in
  { c with asked; formula = Rename.temporal f c.formula }

let permuted rand ?perm n =
  let perm, symmetry = symmetry rand ?perm n.model in
  {
    model = symmetry.model n.model;
    declared = symmetry.state n.declared;
    checks = List.map (renamed (Array.get perm)) n.checks;
  }

let same_verdicts seed change () =
  let rand = Random.State.make [| seed |] in
  List.iter
    (fun name ->
       let n = load name in
       let n = { n with model = change n.model } in
       Alcotest.(check (list string)) name (verdicts n) (verdicts (permuted rand n)))
    names

(* The verdict that told on the order of declaration: with each of the two first. *)
let docking () =
  let text =
    Load.read (Filename.concat folder "docking.sc")
    ^ "\nround orientation 2^-6\ncheck early : EF[4,4] x(tug) < -685/1000\n"
  in
  let n = loaded (Load.exactly (Load.text text)) in
  let swapped = permuted (Random.State.make [| 2 |]) ~perm:[| 1; 0 |] n in
  Alcotest.(check (list string)) "the same verdicts" (verdicts n) (verdicts swapped);
  Alcotest.(check bool) "of something" true (List.length (verdicts n) > 8)

(* {1 Random networks} *)

let random =
  let features = { Random_rigid.anything with rounds = true; laws = true } in
  QCheck2.Test.make ~name:"random networks that turn, fall and are rounded" ~count:16
    ~print:(fun (n, _) -> Random_rigid.print n)
    QCheck2.Gen.(pair (Random_rigid.generate features) int)
    (fun (network, seed) ->
       let m, start = Random_rigid.start network in
       let states = reached { model = m; declared = start; checks = [] } ~limit:8 in
       let _, symmetry = symmetry (Random.State.make [| seed |]) m in
       match Symmetry.broken symmetry m states with
       | None -> true
       | Some why -> QCheck2.Test.fail_report why)

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  let of_variant i ((name, _, _) as variant) = case ("transitions, " ^ name) (transitions (7 + i) variant) in
  ("order and names",
   [
     ("any order of declaration, and other names", List.mapi of_variant variants);
     ( "verdicts",
       [
         case "any order of declaration, and other names" (same_verdicts 3 Fun.id);
         case "with rounding" (same_verdicts 4 rounding); case "docking, rounded" docking;
       ] );
     ("random", Scc_test_support.Property.cases [ random ]);
   ])
