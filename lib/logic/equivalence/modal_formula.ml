open Scc_exact

type modality = Now of int | Weakly of int | Wait of Rat.t

type t = { id : int; size : int; node : node }

and node =
  | Yes
  | Not of t
  | And of t list
  | Can of modality * t
  | Until of t * int * t

type store = { mutable next : int }

let store () = { next = 0 }
let large = 1_000_000
let size f = f.size

let make store node size =
  store.next <- store.next + 1;
  { id = store.next; size = min large size; node }

let yes store = make store Yes 1
let negation store f = match f.node with Not g -> g | _ -> make store (Not f) (1 + f.size)

let conjunction store = function
  | [] -> yes store
  | [ f ] -> f
  | list -> make store (And list) (List.fold_left (fun n f -> min large (n + f.size)) 1 list)

let can store modality f =
  match (modality, f.node) with
  | Wait d, Can (Wait e, g) -> make store (Can (Wait (Rat.add d e), g)) f.size
  | _ -> make store (Can (modality, f)) (1 + f.size)

(* Equal, as far as is seen without looking into them. *)
let same f g = f.id = g.id || (f.node = Yes && g.node = Yes)

let until store phi a psi =
  match psi.node with
  | Yes when Graph.is_tau a -> psi
  | Until (again, _, _) when Graph.is_tau a && same phi again -> psi
  | _ -> make store (Until (phi, a, psi)) (1 + phi.size + psi.size)

(* {1 Truth} *)

type evaluator = {
  system : System.t;
  known : (int * bool * int, bool) Hashtbl.t;  (* of a formula, how sure one is to be, and a position *)
  mutable left : int;  (* steps that may still be made *)
}

exception Too_much

let evaluator ?(most = max_int) system = { system; known = Hashtbl.create 256; left = most }

let step e =
  e.left <- e.left - 1;
  if e.left < 0 then raise Too_much

(* With [sure], whether it holds whatever unknown states can do; without, whether it may hold. *)
let rec holds e ~sure f p =
  match f.node with
  | Yes -> true
  | Not g -> not (holds e ~sure:(not sure) g p)
  | And list -> List.for_all (fun g -> holds e ~sure g p) list
  | Can _ | Until _ -> (
      let key = (f.id, sure, p) in
      match Hashtbl.find_opt e.known key with
      | Some b -> b
      | None ->
        let b = modal e ~sure f p in
        Hashtbl.add e.known key b;
        b)

and modal e ~sure f p =
  step e;
  let m = e.system in
  let unclear ps = (not sure) && List.exists (fun p -> not (System.known m p)) ps in
  let some g = List.exists (holds e ~sure g) in
  match f.node with
  | Can (Now a, g) -> some g (System.after m p a) || unclear [ p ]
  | Can (Weakly a, g) ->
    let before = System.silent_closure m [ p ] in
    let reached =
      if Graph.is_tau a then before
      else System.silent_closure m (List.concat_map (fun p -> System.after m p a) before)
    in
    some g reached || unclear before || unclear reached
  | Can (Wait d, g) -> some g (System.wait m p d) || ((not sure) && System.stuck_waiting m p d)
  | Until (phi, a, psi) -> search e ~sure phi a psi [ p ]
  | Yes | Not _ | And _ -> holds e ~sure f p

and search e ~sure phi a psi from =
  let m = e.system in
  let seen = Hashtbl.create 16 in
  let rec visit = function
    | [] -> false
    | p :: rest when Hashtbl.mem seen p -> visit rest
    | p :: rest ->
      step e;
      Hashtbl.add seen p ();
      let holds g p = holds e ~sure g p in
      (Graph.is_tau a && holds psi p)
      ||
      if not (holds phi p) then visit rest
      else
        ((not sure) && not (System.known m p))
        || ((not (Graph.is_tau a)) && List.exists (holds psi) (System.after m p a))
        || visit (List.rev_append (System.after m p 0) rest)
  in
  visit from

let certainly e f p = holds e ~sure:true f p
let possibly e f p = holds e ~sure:false f p

(* {1 Text} *)

let modality_text label = function
  | Now a -> ("<" ^ label a ^ ">", "[" ^ label a ^ "]")
  | Weakly a -> ("<<" ^ label a ^ ">>", "[[" ^ label a ^ "]]")
  | Wait d ->
    let time = "time(" ^ Rat.to_string d ^ ")" in
    ("<" ^ time ^ ">", "[" ^ time ^ "]")

let to_string ~label f =
  let b = Buffer.create 256 in
  let put = Buffer.add_string b in
  let rec show f =
    match f.node with
    | Yes -> put "true"
    | Not { node = Yes; _ } -> put "false"
    | Not { node = Can (m, g); _ } ->
      put (snd (modality_text label m));
      show_negation g
    | Not g ->
      put "not ";
      show g
    | And list ->
      put "(";
      List.iteri
        (fun i g ->
           if i > 0 then put " and ";
           show g)
        list;
      put ")"
    | Can (m, g) ->
      put (fst (modality_text label m));
      show g
    | Until (phi, a, psi) ->
      put "(";
      show phi;
      put (if Graph.is_tau a then " until " else " until <" ^ label a ^ ">");
      show psi;
      put ")"
  and show_negation f =
    match f.node with
    | Yes -> put "false"
    | Not g -> show g
    | Can (m, g) ->
      put (snd (modality_text label m));
      show_negation g
    | And _ | Until _ ->
      put "not ";
      show f
  in
  show f;
  Buffer.contents b
