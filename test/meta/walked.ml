(* A link that leads nowhere stands for a file that vanishes while the tree is walked. *)
let sources_only () =
  let folder = Filename.temp_file ~temp_dir:"." "walked" "" in
  let inside name = Filename.concat folder name in
  let made = [ ".objs"; "_build"; "below" ] in
  let write name = close_out (open_out (inside name)) in
  let remove () = ignore (Sys.command ("rm -r " ^ Filename.quote folder)) in
  Sys.remove folder;
  Sys.mkdir folder 0o700;
  Fun.protect ~finally:remove (fun () ->
      List.iter (fun name -> Sys.mkdir (inside name) 0o700) made;
      List.iter write [ "a.ml"; ".b.ml"; ".objs/c.cmt"; "_build/d.md"; "below/e.ml" ];
      Unix.symlink "nowhere" (inside "gone.ml");
      let path = "test/meta/" ^ Filename.basename folder in
      Alcotest.(check (list string)) "files" [ path ^ "/a.ml"; path ^ "/below/e.ml" ] (Tree.files path))
