open Cmdliner

let text =
  [
    `S Manpage.s_description;
    `P
      "Explores a model over every non-deterministic choice, and writes the graph of states and transitions for \
       other tools. The bytes are the same from run to run.";
    `P
      "If a bound ended the exploration, a message on standard error and the output say so (states with unknown \
       transitions have the label, or a loop, $(b,unexplored)). So does the exit code, which is that of $(b,scc \
       check) for the exploration.";
    `S "FORMATS";
    `I
      ( "$(b,aut)",
        "Aldebaran's labelled transition systems, for CADP, mCRL2 and merc. Labels are those of $(b,scc trace), \
         such as $(b,time(1/2\\)) and $(b,bind(a, p.right, q.left\\)). $(b,--hide) makes some invisible. \
         Consecutive passings of time, with nothing else possible between them, are one ($(b,--all-steps) keeps \
         them apart). A state in which nothing will ever happen again has the loop $(b,time(forever\\))." );
    `I
      ( "$(b,dot)",
        "A picture for Graphviz, for small graphs. Nodes show the bonds and behaviours that differ between \
         states. Red nodes violate a check, and green nodes satisfy its formula. A chain of passings of time is \
         one edge." );
    `I
      ( "$(b,tra)",
        "The explicit files of PRISM, or of Storm with $(b,--dialect storm): $(i,FILE).tra, .lab and .sta (and \
         .clab for Storm, with actions). The graph is a Markov decision process in which each transition is an \
         action with probability 1. Where a velocity is drawn, all draws of a state are one action (the \
         probabilities are floats here). States without transitions get a loop: $(b,rest) where time passes for \
         ever, $(b,stuck) where not even time passes, $(b,unexplored). $(i,FILE).names.json maps the names to \
         their meanings." );
    `I
      ( "$(b,drn)",
        "The same for Storm in one file, with exact probabilities, and exact durations as the reward model \
         $(b,time). Comments explain the names." );
    `I ("$(b,json)", "The whole graph, with states in full. The schema is $(b,specs/schema/graph.schema.json).");
    `P
      "For a model with ranges of parameters ($(b,-D x=LOW..HIGH) narrows them), or with $(b,split_step any), \
       $(b,dot) and $(b,json) have a graph of sets of states, as $(b,scc check) explores it without reductions. \
       Each set has its constraints, and each edge the values for which it is taken and its duration. The schema \
       is $(b,specs/schema/zones.schema.json). The other formats list single states, and refuse such models. A \
       depth of 1000 is the default bound.";
    `P
      "In $(b,tra) and $(b,drn), a state has the labels $(b,init), $(b,deadlock) (nothing can happen, not even \
       the passing of time), $(b,quiescent) (nothing will ever happen again) and $(b,unexplored). It also has \
       one for each predicate of the model's checks that holds in it: $(b,bound_p_q) for $(b,bound(p, q\\)), and \
       $(b,check_NAME) for the whole predicate of the check $(b,NAME).";
    `P
      "A predicate may change while time passes, and be true for an instant only. Labels of states do not show \
       that; a note on standard error says where it happens. With $(b,--instants) there are states for it, with \
       the label $(b,right_after) where a predicate begins to hold right after an instant, and not at it. Then \
       the answers of a tool about $(b,F), $(b,G) and $(b,U) are about whole continuous runs.";
    `P "Runs are written for Apalache by $(b,scc trace --itf).";
    `S "BOUNDS";
    `P "The exploration ends when nothing is left to explore, or at a bound; some bounds have defaults.";
    `P
      "After an interruption (Ctrl-C) the explored part is written, if that takes no more than half a second of \
       the processor; else nothing is. After $(b,--seconds) and other bounds it is written to its end.";
  ]
  @ Options.diagnostics_man
  @ [
    `S Manpage.s_examples;
    `Pre "  scc explore specs/models/hexokinase.sc -o hexokinase.dot && dot -Tsvg -O hexokinase.dot";
    `Pre "  scc explore specs/models/dimers.sc -o dimers.aut --hide time";
    `Pre "  scc explore specs/models/drift.sc -o drift.drn --instants";
    `Pre "  scc explore specs/models/dimer.sc -o dimer.tra --dialect storm";
    `Pre "  scc explore specs/models/chain.sc -D n=6 -o - --format json";
  ]
