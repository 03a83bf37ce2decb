(* What the tests of elaboration share: a cube, and the way from text to result. *)

open Scc_base

let cube =
  {|shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
|}

let corner =
  {|compound Corner {
  part left : Cube mass 3
  part arm  : Cube scaled (2, 1/2, 1) mass 3 at translate (3, 1/2, 0)
  glue left.right ~ arm.left
}
|}

let no_files path = Error ("no file " ^ path)

let elaborate ?(overrides = []) ?(read_file = no_files) text =
  match Scc_syntax.Parse.parse (Source.make ~name:"test.sc" text) with
  | Error diagnostics -> Error diagnostics
  | Ok model -> Scc_elaborate.Elaborate.elaborate ~read_file ~overrides model

let show text d = Diag.render ~source:(fun _ -> Some (Source.make ~name:"test.sc" text)) d

(* A model that must be in order. *)
let accept ?overrides ?read_file text =
  match elaborate ?overrides ?read_file text with
  | Ok t -> t
  | Error diagnostics -> Alcotest.fail (String.concat "" (List.map (show text) diagnostics))

let underlined text (span : Span.t) = String.sub text span.start (span.stop - span.start)
