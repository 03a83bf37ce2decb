(* Small decision processes, and how they are asked. *)

open Scc_exact
open Scc_chance
module Property = Scc_test_support.Property

let rat n d = Rat.make (Z.of_int n) (Z.of_int d)

(* {1 By the definition} *)

(* A state is a list of choices: a reward, and pairs of a target and a weight. *)
type plain = (int * (int * int) list) list array

let build (p : plain) =
  let b = Mdp.builder () in
  Array.iter
    (fun choices ->
       ignore (Mdp.add_state b);
       List.iter
         (fun (reward, branches) ->
            let sum = List.fold_left (fun s (_, w) -> s + w) 0 branches in
            Mdp.add_choice b ~reward:(Rat.of_int reward) (List.map (fun (t, w) -> (t, rat w sum)) branches))
         choices)
    p;
  match Mdp.finish b with Ok m -> m | Error e -> Alcotest.fail (Mdp.describe e)

type case = { plain : plain; goal : bool array; stay : bool array }

let print { plain; goal; stay } =
  let branches l = String.concat " " (List.map (fun (t, w) -> Printf.sprintf "%d:%d" t w) l) in
  let choice (r, l) = Printf.sprintf "(%d) %s" r (branches l) in
  String.concat "\n"
    (Array.to_list
       (Array.mapi
          (fun s c ->
             Printf.sprintf "%d%s%s: %s" s (if goal.(s) then " goal" else "") (if stay.(s) then "" else " left")
               (String.concat " | " (List.map choice c)))
          plain))

let question c =
  Qualitative.until (Backwards.make (build c.plain)) ~stay:(Array.get c.stay) ~goal:(Array.get c.goal)

let all_states c f =
  let ok = ref true in
  Array.iteri (fun s _ -> if not (f s) then ok := false) c.plain;
  !ok

let both f = f Equations.Min && f Equations.Max

let exactly = { Effort.default with engine = Exactly }
let nearly = { Effort.default with engine = Nearly; width = rat 1 1_000_000_000 }

(* {1 Closed forms} *)

(* A walk on 0 .. n, to the right with the probability p, from k: the ends are absorbing. *)
let walk n p =
  let b = Mdp.builder () in
  for s = 0 to n do
    ignore (Mdp.add_state b);
    if s = 0 || s = n then Mdp.add_choice b [ (s, Rat.one) ]
    else Mdp.add_choice b ~reward:Rat.one [ (s + 1, p); (s - 1, Rat.sub Rat.one p) ]
  done;
  match Mdp.finish b with Ok m -> m | Error e -> Alcotest.fail (Mdp.describe e)

let rec power x n = if n = 0 then Rat.one else Rat.mul x (power x (n - 1))

let ruin_probability n p k =
  let q = Rat.sub Rat.one p in
  if Rat.equal p q then Rat.sub Rat.one (rat k n)
  else
    let r = Rat.div q p in
    Rat.div (Rat.sub (power r k) (power r n)) (Rat.sub Rat.one (power r n))

let expected_duration n p k =
  let q = Rat.sub Rat.one p in
  if Rat.equal p q then Rat.of_int (k * (n - k))
  else
    let r = Rat.div q p in
    let d = Rat.sub q p in
    Rat.sub (Rat.div (Rat.of_int k) d)
      (Rat.mul (Rat.div (Rat.of_int n) d) (Rat.div (Rat.sub Rat.one (power r k)) (Rat.sub Rat.one (power r n))))

let law name ?(count = 1000) gen print f = Property.case (QCheck2.Test.make ~name ~count ~print gen f)

