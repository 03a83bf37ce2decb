open Scc_ctl
open Scc_exact

(* Steps of a run. Times are counted in halves of the unit. Who starts at an offset inside an open interval is
   put into the middle of it: at a [Middle], with the second half of the interval to come. *)
type place =
  | Node of int
  | Whole of int * int  (** a cell of a flow: an instant, or the interval from its beginning on *)
  | Middle of int * int
  | Half of int * int

type step = {
  place : place;
  length : int;  (** 0 for what is one instant *)
  jumps : int list;  (** by edges *)
  passes : int list;  (** by the passing of time *)
  hidden : bool;
}

type answer = { surely : bool; perhaps : bool }

type t = {
  small : Small.t;
  steps : step array;
  numbers : (place, int) Hashtbl.t;
  mutable known : (Timed_formula.t * answer array) list;  (** by step *)
}

let make (g : Small.t) =
  let numbers = Hashtbl.create 64 and places = ref [] and n = ref 0 in
  let add p =
    Hashtbl.add numbers p !n;
    places := p :: !places;
    incr n
  in
  (* A ray has two cells more, an instant and an interval, which are repeated. *)
  let cells (x : Small.node) =
    if not x.known then 0 else match x.flow with Ray _ -> Small.cells x + 2 | _ -> Small.cells x
  in
  Array.iteri
    (fun s x ->
       add (Node s);
       for i = 0 to cells x - 1 do
         add (Whole (s, i));
         if i land 1 = 0 then begin
           add (Middle (s, i));
           add (Half (s, i))
         end
       done)
    g.nodes;
  let number p = Hashtbl.find numbers p in
  let after s i =
    let x = g.nodes.(s) in
    if i + 1 < cells x then [ number (Whole (s, i + 1)) ]
    else
      match x.flow with
      | Lasts (_, targets) -> List.map (fun t -> number (Node t)) targets
      | Ray _ -> [ number (Whole (s, i - 1)) ]
      | No_flow -> []
  in
  let step place =
    let plain length passes = { place; length; jumps = []; passes; hidden = false } in
    match place with
    | Node s ->
      let x = g.nodes.(s) in
      if not x.known then { (plain 0 []) with hidden = true }
      else
        let passes = if cells x > 0 then [ number (Whole (s, 0)) ] else [] in
        { (plain 0 passes) with jumps = List.map (fun t -> number (Node t)) x.edges }
    | Whole (s, i) -> plain (if i land 1 = 0 then 2 else 0) (after s i)
    | Middle (s, i) -> plain 0 [ number (Half (s, i)) ]
    | Half (s, i) -> plain 1 (after s i)
  in
  { small = g; steps = Array.of_list (List.rev_map step !places); numbers; known = [] }

(* All of an open interval is like its middle. *)
let judge t v =
  Array.map
    (fun x ->
       match x.place with
       | Whole (s, i) when i land 1 = 0 -> v.(Hashtbl.find t.numbers (Middle (s, i)))
       | Half (s, i) -> v.(Hashtbl.find t.numbers (Middle (s, i)))
       | Node _ | Middle _ | Whole _ -> v.(Hashtbl.find t.numbers x.place))
    t.steps

let predicate t p =
  let truth x =
    match x.place with
    | Node s -> t.small.nodes.(s).at.(p)
    | Whole (s, i) | Middle (s, i) | Half (s, i) -> Small.cell t.small.nodes.(s).cells.(p) i
  in
  Array.map
    (fun x ->
       match truth x with
       | T -> { surely = true; perhaps = true }
       | F -> { surely = false; perhaps = false }
       | U -> { surely = false; perhaps = true })
    t.steps

(** {1 Until} *)

(* In halves; without an end, the clock stands still at the beginning of the window. *)
type window = { from : int; until : int option }

let window t (b : Timed_formula.bound) =
  let halves r =
    let x = Rat.div (Rat.mul (Rat.of_int 2) r) t.small.unit in
    if Rat.is_integer x then Z.to_int (Rat.floor x) else failwith "not on the grid"
  in
  { from = halves b.low; until = Option.map halves b.high }

let top w = match w.until with Some b -> b + 1 | None -> w.from
let tick w c length = Int.min (top w) (c + length)

let in_window w c length =
  let before = match w.until with None -> true | Some b -> if length = 0 then c <= b else c < b in
  before && if length = 0 then c >= w.from else c + length > w.from || c >= w.from

let is_over w c = match w.until with None -> false | Some b -> c > b

(* What there is to say of one step at a time, before its successors are asked. *)
type here = Met | Broken | Goes_on

let here t w ~f ~g k c =
  let x = t.steps.(k) in
  let met = g.(k) && in_window w c x.length in
  if is_over w c then Broken
  else if x.length = 0 then if met then Met else if f.(k) then Goes_on else Broken
  else if not f.(k) then Broken
  else if met then Met
  else Goes_on

let successors t w k c =
  let x = t.steps.(k) in
  let c' = tick w c x.length in
  List.map (fun k' -> (k', c')) (x.jumps @ x.passes)

(* Some run: the least fixpoint, by going over everything until nothing changes. *)
let some t w ~generous ~f ~g =
  let n = Array.length t.steps and m = top w + 1 in
  let holds = Array.make_matrix n m false in
  let changed = ref true in
  while !changed do
    changed := false;
    for k = 0 to n - 1 do
      for c = 0 to m - 1 do
        let now =
          match here t w ~f ~g k c with
          | Met -> true
          | Broken -> false
          | Goes_on ->
            if t.steps.(k).hidden then generous
            else List.exists (fun (k, c) -> holds.(k).(c)) (successors t w k c)
        in
        if now && not holds.(k).(c) then begin
          holds.(k).(c) <- true;
          changed := true
        end
      done
    done
  done;
  Array.init n (fun k -> holds.(k).(0))

(* The places and times from which some run has f fail before g, or ends, or goes on without end and without g,
   whether or not time does: the greatest fixpoint, by taking away whatever has no such way on. *)
let every t w ~generous ~f ~g =
  let n = Array.length t.steps and m = top w + 1 in
  let against = Array.make_matrix n m true in
  let changed = ref true in
  while !changed do
    changed := false;
    for k = 0 to n - 1 do
      for c = 0 to m - 1 do
        let still =
          match here t w ~f ~g k c with
          | Met -> false
          | Broken -> true
          | Goes_on -> (
              if t.steps.(k).hidden then not generous
              else
                match successors t w k c with
                | [] -> true
                | ways -> List.exists (fun (k, c) -> against.(k).(c)) ways)
        in
        if against.(k).(c) && not still then begin
          against.(k).(c) <- false;
          changed := true
        end
      done
    done
  done;
  Array.init n (fun k -> not against.(k).(0))

(** {1 Probabilities} *)

(* A decision process whose states are steps and clocks, two more for the ends. Its solver is tested by itself. *)
let likely t w (side : Timed_formula.side) ~generous ~f ~g =
  let open Scc_chance in
  let n = Array.length t.steps and m = top w + 1 in
  let state (k, c) = 2 + (k * m) + c in
  let b = Mdp.builder () in
  let add choices =
    ignore (Mdp.add_state b);
    List.iter (Mdp.add_choice b) choices
  in
  let sure s = [ (s, Rat.one) ] in
  add [ sure 0 ];
  add [ sure 1 ];
  let ways k c =
    let x = t.steps.(k) in
    let c' = tick w c x.length in
    let to_ k' = state (k', c') in
    let jumps =
      match x.place with
      | Node s when t.small.nodes.(s).drawn ->
        let node = t.small.nodes.(s) in
        let drawn, others = Small.split node x.jumps in
        List.map2 (fun k' p -> (to_ k', p)) drawn (Small.chances node) :: List.map (fun k' -> sure (to_ k')) others
      | _ -> List.map (fun k' -> sure (to_ k')) x.jumps
    in
    jumps @ List.map (fun k' -> sure (to_ k')) x.passes
  in
  for k = 0 to n - 1 do
    for c = 0 to m - 1 do
      add
        (match here t w ~f ~g k c with
         | Met -> [ sure 0 ]
         | Broken -> [ sure 1 ]
         | Goes_on when t.steps.(k).hidden -> [ sure (if generous then 0 else 1) ]
         | Goes_on -> ( match ways k c with [] -> [ sure 1 ] | ways -> ways))
    done
  done;
  let mdp = match Mdp.finish b with Ok m -> m | Error e -> failwith (Mdp.describe e) in
  let q = Qualitative.until (Backwards.make mdp) ~stay:(fun s -> s <> 1) ~goal:(fun s -> s = 0) in
  let direction = match side with Least -> Equations.Min | Greatest -> Max in
  let found = Reach.solve q direction Effort.default ~asked:All in
  Array.init n (fun k -> Solution.value found (state (k, 0)))

(** {1 Formulas} *)

let low v = Array.map (fun a -> a.surely) v
let high v = Array.map (fun a -> a.perhaps) v
let both l h = Array.map2 (fun surely perhaps -> { surely; perhaps }) l h
let negation v = Array.map (fun a -> { surely = not a.perhaps; perhaps = not a.surely }) v

let next t ~generous f =
  let holds = Array.make (Array.length t.steps) false in
  for _ = 1 to Array.length t.steps do
    Array.iteri
      (fun k x ->
         if
           (x.hidden && generous)
           || List.exists (fun j -> f.(j)) x.jumps
           || List.exists (fun j -> holds.(j)) x.passes
         then holds.(k) <- true)
      t.steps
  done;
  holds

let rec value t (f : Timed_formula.t) =
  match List.find_opt (fun (g, _) -> Timed_formula.compare f g = 0) t.known with
  | Some (_, v) -> v
  | None ->
    let v = judge t (compute t f) in
    t.known <- (f, v) :: t.known;
    v

and compute t f =
  let until (q : Timed_formula.quantifier) b f g =
    let w = window t b in
    match q with
    | Chance { side; test } ->
      let least = likely t w side ~generous:false ~f:(low f) ~g:(low g) in
      let most = likely t w side ~generous:true ~f:(high f) ~g:(high g) in
      let holds a = Option.get (Scc_chance.Answer.holds a test) in
      let l = Array.map holds least and h = Array.map holds most in
      (match test.relation with At_least_so | More -> both l h | Less | At_most -> both h l)
    | Exists ->
      both
        (some t w ~generous:false ~f:(low f) ~g:(low g))
        (some t w ~generous:true ~f:(high f) ~g:(high g))
    | All ->
      both
        (every t w ~generous:false ~f:(low f) ~g:(low g))
        (every t w ~generous:true ~f:(high f) ~g:(high g))
  in
  let always = Array.map (fun _ -> { surely = true; perhaps = true }) t.steps in
  let all v w = Array.map2 (fun a b -> { surely = a.surely && b.surely; perhaps = a.perhaps && b.perhaps }) v w in
  let next f = both (next t ~generous:false (low f)) (next t ~generous:true (high f)) in
  match f with
  | Predicate p -> predicate t p
  | Not f -> negation (value t f)
  | And l -> List.fold_left all always (List.map (value t) l)
  | Or l -> negation (List.fold_left all always (List.map (fun f -> negation (value t f)) l))
  | Next (Exists, f) -> next (value t f)
  | Next (Chance _, _) -> failwith "a probability of the next transition"
  | Next (All, f) -> negation (next (negation (value t f)))
  | Until (q, b, f, g) -> until q b (value t f) (value t g)
  | Finally (q, b, g) -> until q b always (value t g)
  | Globally (All, b, g) -> negation (until Exists b always (negation (value t g)))
  | Globally (Exists, b, g) -> negation (until All b always (negation (value t g)))
  | Globally (Chance { side; test }, b, g) ->
    let chance : Timed_formula.chance =
      {
        side = (match side with Least -> Greatest | Greatest -> Least);
        test =
          {
            than = Rat.sub Rat.one test.than;
            relation =
              (match test.relation with Less -> More | More -> Less | At_most -> At_least_so | At_least_so ->
                   At_most); };
      }
    in
    until (Chance chance) b always (negation (value t g))

let node t f s = (value t f).(Hashtbl.find t.numbers (Node s))

let cell t f s i =
  (value t f).(Hashtbl.find t.numbers (if i land 1 = 0 then Middle (s, i) else Whole (s, i)))
