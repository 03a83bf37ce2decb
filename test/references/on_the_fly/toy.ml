open Scc_ctl
open Scc_exact

type truth = F | T | U
type edge = { target : int; duration : int; cells : truth array }
type ahead = Edges of edge list | Ray of truth array | Dead_end
type node = { at : truth; ahead : ahead }
type t = node array

let truth = function F -> Truth.False | T -> Truth.True | U -> Truth.Undecided "toy"

(* {1 As a transition system} *)

module System = struct
  type context = t
  type fault = unit

  let width _ = 1
  let initial _ = [| 0 |]

  (* The label of a transition is its duration. *)
  let successors g (s : int array) =
    let step e = { Scc_graph_search.Lts.label = e.duration; changes = [| 0; e.target |] } in
    Ok (match g.(s.(0)).ahead with Edges l -> List.map step l | Ray _ | Dead_end -> [])

  let reduced _ _ = None
  let entered _ _ = ()
  let transitions _ _ = 1
  let longest _ = 0
  let bits _ _ = 0
  let duration _ d = Rat.of_int d

  include Scc_graph_search.Lts.Alone
end

(* Cell 2k is the open interval (k, k + 1), cell 2k - 1 the instant k. *)
let cell cells r =
  let k = Z.to_int (Rat.floor r) in
  let i = if Rat.is_integer r then (2 * k) - 1 else 2 * k in
  cells.(Int.min i (Array.length cells - 1))

let timeline g s extent =
  let cells =
    match (g.(s).ahead, extent) with
    | Edges l, Timeline.Lasts d ->
      (List.find (fun e -> Rat.equal (Rat.of_int e.duration) d) l).cells
    | Ray cells, Timeline.Forever -> cells
    | _ -> failwith "no such trajectory"
  in
  let cuts = List.init ((Array.length cells + 1) / 2) (fun k -> Rat.of_int (k + 1)) in
  Timeline.of_cuts extent cuts Truth.equal (fun r ->
      truth (if Rat.sign r = 0 then g.(s).at else cell cells r))

let rests g s = match g.(s).ahead with Ray _ -> true | Edges _ | Dead_end -> false

(* {1 Random ones} *)

module Gen = QCheck2.Gen

let truth_gen ~goal ~unsure = Gen.frequency [ (10, Gen.return F); (goal, Gen.return T); (unsure, Gen.return U) ]

let node_gen n truth =
  let open Gen in
  let edge duration =
    let* target = int_range 0 (n - 1) in
    let* cells = array_repeat (Int.max 0 ((2 * duration) - 1)) truth in
    return { target; duration; cells }
  in
  (* A time transition is known by its duration: those of one state differ. *)
  let edges =
    let* instant = list_size (int_range 0 2) (edge 0) in
    let* durations = oneofl [ []; [ 1 ]; [ 2 ]; [ 3 ]; [ 2; 1 ] ] in
    let* timed = flatten_l (List.map edge durations) in
    return (instant @ timed)
  in
  let* at = truth in
  let* ends = int_range 0 5 in
  let* list = edges in
  let* ray = bind (int_range 1 4) (fun k -> array_repeat ((2 * k) - 1) truth) in
  match (list, ends) with
  | [], 0 -> return { at; ahead = Dead_end }
  | [], _ | _ :: _, 1 -> return { at; ahead = Ray ray }
  | _ -> return { at; ahead = Edges list }

(* Runs meet on a ring without duration, at places and times of their own. *)
let ring_gen =
  let open Gen in
  let free target duration = { target; duration; cells = Array.make (Int.max 0 ((2 * duration) - 1)) F } in
  let node l = { at = F; ahead = Edges l } in
  let* durations = oneofl [ [ 1; 2; 3 ]; [ 3; 1; 2 ]; [ 2; 3; 1 ] ] in
  let start = node (List.mapi (fun i d -> free (i + 1) d) durations) in
  let* last = array_repeat 5 (truth_gen ~goal:5 ~unsure:0) in
  let leave = { target = 4; duration = 3; cells = last } in
  let ring i = node (free ((i mod 3) + 1) 0 :: (if i = 2 then [ leave ] else [])) in
  let* at = truth_gen ~goal:5 ~unsure:0 in
  return [| start; ring 1; ring 2; ring 3; { at; ahead = Ray [| T |] } |]

let any_gen =
  let open Gen in
  let* n = int_range 1 7 in
  let* goal = oneofl [ 0; 1; 2; 5; 60 ] in
  let* unsure = oneofl [ 0; 0; 1 ] in
  array_repeat n (node_gen n (truth_gen ~goal ~unsure))

let print g =
  let t = function F -> "." | T -> "T" | U -> "?" in
  let cells a = String.concat "" (Array.to_list (Array.map t a)) in
  let ahead = function
    | Dead_end -> "dead end"
    | Ray a -> "ray " ^ cells a
    | Edges l ->
      String.concat ", "
        (List.map (fun e -> Printf.sprintf "->%d in %d [%s]" e.target e.duration (cells e.cells)) l)
  in
  String.concat "\n"
    (Array.to_list (Array.mapi (fun i x -> Printf.sprintf "%d %s: %s" i (t x.at) (ahead x.ahead)) g))

let gen = Gen.frequency [ (9, any_gen); (1, ring_gen) ]

(* {1 Unrolled, cell by cell} *)

(* A point or an open interval of some trajectory, and the time since the start in halves: even at
   instants 0, 1, 2, …, odd in between. *)
type cell = {
  place : int * int * int;  (** state, choice (-1 at the state itself, -2 on the ray), cell *)
  clock : int;
}

let value g (s, choice, i) =
  match (choice, g.(s).ahead) with
  | -1, _ -> g.(s).at
  | -2, Ray a -> a.(Int.min i (Array.length a - 1))
  | k, Edges l -> (List.nth l k).cells.(i)
  | _ -> failwith "no such cell"

let next g { place = s, choice, i; clock } =
  match (choice, g.(s).ahead) with
  | -1, Dead_end -> []
  | -1, Ray _ -> [ { place = (s, -2, 0); clock = clock + 1 } ]
  | -1, Edges l ->
    List.mapi
      (fun k e ->
         if e.duration = 0 then { place = (e.target, -1, 0); clock }
         else { place = (s, k, 0); clock = clock + 1 })
      l
  | -2, Ray a -> [ { place = (s, -2, Int.min (i + 1) (Array.length a - 1)); clock = clock + 1 } ]
  | k, Edges l ->
    let e = List.nth l k in
    let last = i = Array.length e.cells - 1 in
    [ { place = (if last then (e.target, -1, 0) else (s, k, i + 1)); clock = clock + 1 } ]
  | _ -> failwith "no such cell"

(* All cells reached through cells that pass, and the steps between them; clocks are capped. *)
let reach g ~cap ~pass =
  let seen = Hashtbl.create 64 in
  let rec go c =
    let c = { c with clock = Int.min c.clock cap } in
    if pass c && not (Hashtbl.mem seen c) then begin
      Hashtbl.add seen c ();
      List.iter go (next g c)
    end
  in
  go { place = (0, -1, 0); clock = 0 };
  Hashtbl.fold (fun c () acc -> c :: acc) seen []

let counts g ~unsure place =
  match value g place with T -> true | F -> false | U -> unsure

let possibly g ~within ~unsure =
  let cap = match within with None -> 0 | Some t -> (2 * t) + 1 in
  let in_time c = match within with None -> true | Some t -> c.clock <= 2 * t in
  List.exists
    (fun c -> in_time c && counts g ~unsure c.place)
    (reach g ~cap ~pass:(fun _ -> true))

type inevitable = Yes | No | Zeno

(* The clock is capped just past the bound, where nothing counts any more; without a bound it stays 0 and
   the passing of time is seen in the steps. *)
let inevitable g ~within ~unsure =
  let cap = match within with None -> 0 | Some t -> (2 * t) + 1 in
  let over c = match within with None -> false | Some _ -> c.clock = cap in
  let avoids c = over c || not (counts g ~unsure c.place) in
  let cells = reach g ~cap ~pass:avoids in
  let capped c = { c with clock = Int.min c.clock cap } in
  let returns c ~timed =
    (* Whether the cell is met again, with time passing on the way or without. *)
    let seen = Hashtbl.create 64 in
    let rec go passed x =
      List.iter
        (fun y ->
           let passed = passed || y.clock > x.clock in
           let y = capped y in
           if avoids y && (timed || not passed) && not (Hashtbl.mem seen (y, passed)) then begin
             Hashtbl.add seen (y, passed) ();
             go passed y
           end)
        (next g x)
    in
    go false c;
    Hashtbl.mem seen (c, timed)
  in
  let dead c =
    match c.place with
    | s, -1, _ -> ( match g.(s).ahead with Dead_end -> true | _ -> false)
    | _ -> false
  in
  if List.exists (fun c -> over c || dead c || returns c ~timed:true) cells then No
  else if List.exists (fun c -> returns c ~timed:false) cells then Zeno
  else Yes
