(* Positions of the cycle are 0 … n-1. A chord is an edge, or a diagonal with a reflex end (a diagonal between two
   corners that are not reflex can always be left out). Of a chord (i, k), i < k, [least] is the least number of
   convex pieces of the polygon i, i+1, …, k; it is 0 of an edge.

   The piece at the chord (i, k) is a chain of chords i = v0, v1, …, vm = k that turns nowhere to the right, with
   the chord back. For one i, [cost] of a chord (a, b) is the least sum of [least] over the chains from i whose
   last chord it is, and [first] the greatest v1 of those: the narrowest at i. One that costs more need not be
   kept: it is no better than the chain that begins with the chord (i, a), and has this diagonal as another cut.
   All of a chain is left of its first chord, and i is left of all others, so that it winds around i less than
   half a turn: no right turns, also at its ends, make it convex. *)

type t = {
  g : Grid.t;
  at : int array;
  into : (int * int) array array;  (* for each b the chords (a, b), a < b: a, and the number of the chord *)
  least : int array;  (* by chord *)
  cost : int array;
  first : int array;
  before : int array;  (* the chord before the last one of the chain; -1 for none *)
  live : (int * int) list array;  (* for each b those of [into] with a chain from the i at hand, in that order *)
}

let never = max_int / 4

let chords (c : Cycle.t) =
  let n = Array.length c.at in
  let reflex = Array.init n (Cycle.reflex c) in
  let is_edge a b = b = a + 1 || (a = 0 && b = n - 1) in
  let is_chord a b = is_edge a b || ((reflex.(a) || reflex.(b)) && Cycle.sees c a b) in
  let count = ref 0 in
  let number a =
    incr count;
    (a, !count - 1)
  in
  let into b = Array.of_list (List.map number (List.filter (fun a -> is_chord a b) (List.init b Fun.id))) in
  let into = Array.init n into in
  (into, !count)

let orient t a b c = Grid.orient t.g t.at.(a) t.at.(b) t.at.(c)
let turns t a b c = Grid.turns t.g t.at.(a) t.at.(b) t.at.(c)

(* The place in [into] of the first chord that does not begin before i. *)
let first_from (list : (int * int) array) i =
  let rec between low high =
    if low >= high then low
    else
      let middle = (low + high) / 2 in
      if fst list.(middle) < i then between (middle + 1) high else between low middle
  in
  between 0 (Array.length list)

let iter_from f list i =
  for k = first_from list i to Array.length list - 1 do
    f list.(k)
  done

(* The best chain from i that ends with the chord (a, b), i < a. *)
let extend t i b (a, chord) =
  t.cost.(chord) <- never;
  let after (p, last) =
    let cost = t.cost.(last) + t.least.(chord) and first = t.first.(last) in
    let better = cost < t.cost.(chord) || (cost = t.cost.(chord) && first > t.first.(chord)) in
    if better && turns t p a b && orient t i first b >= 0 then begin
      t.cost.(chord) <- cost;
      t.first.(chord) <- first;
      t.before.(chord) <- last
    end
  in
  match t.live.(a) with
  | [] -> ()
  | live -> if orient t a b i >= 0 && not (Grid.same t.g t.at.(b) t.at.(i)) then List.iter after live

(* The last chord of the best piece at the chord (i, b), and what it costs. *)
let close t i b =
  let best (found, cost) (a, chord) =
    if a > i && t.cost.(chord) < cost && turns t a b i && turns t b i t.first.(chord) then (chord, t.cost.(chord))
    else (found, cost)
  in
  Array.fold_left best (-1, never) t.into.(b)

(* All chains from i, up to the position [upto]; what closes the piece there. *)
let chains t i ~upto =
  let closing = ref (-1) in
  for b = i + 1 to upto do
    iter_from (extend t i b) t.into.(b) (i + 1);
    iter_from
      (fun (a, chord) ->
         if a = i then begin
           let last, cost = close t i b in
           closing := last;
           if b > i + 1 then t.least.(chord) <- (if cost < never then cost + 1 else never);
           t.cost.(chord) <- t.least.(chord);
           t.first.(chord) <- b;
           t.before.(chord) <- -1
         end)
      t.into.(b) i;
    let live = ref [] in
    iter_from (fun (a, chord) -> if t.cost.(chord) < never then live := (a, chord) :: !live) t.into.(b) i;
    t.live.(b) <- List.rev !live
  done;
  !closing

(* The positions of the chain that ends with a chord, in their order. *)
let chain t ends last =
  let rec back chord found =
    let found = fst ends.(chord) :: found in
    if t.before.(chord) < 0 then found else back t.before.(chord) found
  in
  back last [ snd ends.(last) ]

let pieces (c : Cycle.t) =
  let n = Array.length c.at in
  let into, count = chords c in
  let ends = Array.make count (0, 0) in
  Array.iteri (fun b list -> Array.iter (fun (a, chord) -> ends.(chord) <- (a, b)) list) into;
  let zeros () = Array.make count 0 in
  let t =
    { g = c.grid; at = c.at; into; least = zeros (); cost = zeros (); first = zeros (); before = zeros ();
      live = Array.make n [] }
  in
  for i = n - 1 downto 0 do
    ignore (chains t i ~upto:(n - 1))
  done;
  let rec cut found = function
    | [] -> found
    | (i, k) :: rest ->
      let last = chains t i ~upto:k in
      if last < 0 then Scc_base.Bug.fail __POS__ "a polygon without a partition";
      let positions = chain t ends last in
      let inner = List.filter (fun (a, b) -> b <> a + 1) (Scc_data.Lists.neighbours positions) in
      cut (Array.of_list (List.map (fun p -> c.at.(p)) positions) :: found) (inner @ rest)
  in
  cut [] [ (0, n - 1) ]
