(* Bodies that run into each other at one instant. *)

module Gen = QCheck2.Gen

let cube = "shape Cube = box(1, 1, 1)\nshape Small = box(1/2, 1/2, 1/2)\n"

let body ?(shape = "Cube") ?(v = "0,0,0") name at behaviour =
  Printf.sprintf "process %s = %s mass 1 velocity (%s) at translate (%s) [%s]\n" name shape v at behaviour

let any = "{left, right, top, bottom, front, back}"
let site = Printf.sprintf "<a, %s>. nil" any
let key = Printf.sprintf "<~a, %s>. nil" any

(* Some that run into each other at one or two instants, most of them into the one in the middle. *)
let faces = [ any; "{left, right}"; "{left, right, front, back}" ]

let behaviour =
  let open Gen in
  let* name = oneofl [ "a"; "~a"; "a"; "~a"; "b"; "~b" ] and* where = oneofl faces in
  let plain = match name.[0] with '~' -> String.sub name 1 1 | _ -> name in
  let+ next =
    oneofl
      [
        "nil"; "nil"; Printf.sprintf "rho({<%s, %s>}). nil" plain any;
        Printf.sprintf "eps(1). rho({<%s, %s>}). nil" plain any;
        Printf.sprintf "<b, %s>. nil" any; Printf.sprintf "<~b, %s>. nil" any;
      ]
  in
  Printf.sprintf "<%s, %s>. %s" name where next

let sum = Gen.(map (String.concat " + ") (list_size (frequencyl [ (3, 1); (2, 2); (1, 3) ]) behaviour))

(* What is asked for: so many bonds of a name, or that a body is bound to the one in the middle. *)
type goal = Bonds of string * int | Bound of string

let formula = function
  | Bonds (name, count) -> Printf.sprintf "bonds(%s) >= %d" name count
  | Bound leaf -> Printf.sprintf "bound(%s, s)" leaf

let ways_in = [| (1, 0); (-1, 0); (0, 1); (0, -1) |]

let scene =
  let open Gen in
  let* others = 2 -- 4 in
  let* chance = frequencyl [ (3, None); (1, Some "wait"); (1, Some "stop"); (1, Some "bounce") ] in
  let* middle = oneofl [ "fixed"; "free" ] and* drain = frequencyl [ (4, false); (1, true) ] in
  let* inner = sum in
  let* outer = list_repeat others (triple sum (oneofl [ 2; 2; 3 ]) (oneofl [ 1; 1; 2 ])) in
  let* cyclic = frequencyl [ (3, ""); (1, "bonds cyclic\n") ] in
  let* goal = oneofl [ Bonds ("a", 2); Bonds ("b", 1); Bonds ("a", 1); Bound "w0"; Bound "w1"; Bound "w1" ] in
  let one i (b, far, speed) =
    let x, y = ways_in.(i) in
    let far = 1 + (far * speed) in
    body (Printf.sprintf "w%d" i) ~v:(Printf.sprintf "%d,%d,0" (-x * speed) (-y * speed))
      (Printf.sprintf "%d,%d,0" (x * far) (y * far)) b
  in
  let motion = match chance with
    | None -> ""
    | Some how ->
      Printf.sprintf "timestep 1 steady\nblocked %s\n" how
      ^ String.concat "" (List.init (Int.min 2 others) (fun i ->
          let x, y = ways_in.(i) in
          Printf.sprintf "motion w%d = choose { (%d,%d,0) weight 2, (0,0,0) }\n" i (-x) (-y)))
  in
  let+ top = bool in
  let text =
    cube ^ cyclic
    ^ "fixed far = Cube at translate (99, 99, 99) [<a, {left}>. nil + <b, {left}>. nil]\n"
    ^ (if middle = "fixed" then Printf.sprintf "fixed s = Cube [%s]\n" inner else body "s" "0,0,0" inner)
    ^ (if drain then "fixed drain = Cube absorb at translate (1,1,0)\n" else "")
    ^ (if top then body "top" "0,0,3" ~v:"0,0,-1" inner else "")
    ^ String.concat "" (List.mapi one outer)
    ^ motion
  in
  (text, goal)

